// A picture with a mask and strokes over it, which can be zoomed and moved.

class Desk {
  /** @param canvas  it is drawn into, as large as its style makes it. */
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    this.strokes = [];  // {phase, width, points}
    this.passing = [];  // drawn, and not yet known to the program
    this.erased = new Set();
    this.opacity = 0.45;
    this.shows_uncertain = this.shows_strokes = true;
    this.scale = 1;  // screen pixels a pixel of the picture
    this.left = this.top = 0;  // of the window on the picture [px of it]
    new ResizeObserver(() => this.fill()).observe(canvas);
  }

  /** @param bytes  red, green and blue, shape (picture.shown_rows, picture.shown_cols, 3). */
  take_photo(picture, bytes) {
    this.picture = picture;
    const size = picture.shown_rows * picture.shown_cols;
    const data = new Uint8ClampedArray(4 * size).fill(255);
    for (let i = 0; i < size; ++i) {
      data[4 * i] = bytes[3 * i];
      data[4 * i + 1] = bytes[3 * i + 1];
      data[4 * i + 2] = bytes[3 * i + 2];
    }
    this.photo = this.sheet(picture.shown_cols, picture.shown_rows, data);
    this.fill();
    this.fit();
  }

  /** @param bytes  labels, then flags: 1 = a boundary, 2 = uncertain.   @param colours  of labels, "#rrggbb". */
  take_mask(mask, bytes, colours) {
    const size = mask.rows * mask.cols;
    const [phases, lines, doubts] = [0, 1, 2].map(() => new Uint8ClampedArray(4 * size));
    const rgb = colours.map((colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)));
    for (let i = 0; i < size; ++i) {
      phases.set(rgb[bytes[i]], 4 * i);
      phases[4 * i + 3] = 255;
      const flags = bytes[size + i];
      if (flags & 1) lines.set([255, 255, 255, 235], 4 * i);
      const stripe = ((i % mask.cols) + Math.floor(i / mask.cols)) % 8;
      if (flags & 2 && stripe < 4) doubts.set(stripe === 0 ? [0, 0, 0, 255] : [255, 230, 0, 255], 4 * i);
    }
    const sheet = (data) => this.sheet(mask.cols, mask.rows, data);
    this.mask = { ...mask, phases: sheet(phases), lines: sheet(lines), doubts: sheet(doubts) };
    this.draw();
  }

  no_mask() {
    this.mask = null;
    this.draw();
  }

  sheet(cols, rows, data) {
    const canvas = document.createElement("canvas");
    canvas.width = cols;
    canvas.height = rows;
    canvas.getContext("2d").putImageData(new ImageData(data, cols, rows), 0, 0);
    return canvas;
  }

  /** Brings the canvas to the pixels of the screen. */
  fill() {
    const box = this.canvas.getBoundingClientRect();
    this.ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.max(1, Math.round(box.width * this.ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * this.ratio));
    if (this.fits) this.fit();
    this.draw();
  }

  fit() {
    if (!this.picture) return;
    const { cols, rows } = this.picture;
    const box = this.canvas.getBoundingClientRect();
    this.scale = Math.min(box.width / cols, box.height / rows);
    this.left = (cols - box.width / this.scale) / 2;
    this.top = (rows - box.height / this.scale) / 2;
    this.fits = true;
    this.draw();
  }

  /** @param x, y  on the canvas [screen px], which stay over the same pixel. */
  zoom(factor, x, y) {
    const scale = Math.min(40, Math.max(0.02, this.scale * factor));
    this.left += x / this.scale - x / scale;
    this.top += y / this.scale - y / scale;
    this.scale = scale;
    this.fits = false;
    this.draw();
  }

  move(dx, dy) {
    this.left -= dx / this.scale;
    this.top -= dy / this.scale;
    this.fits = false;
    this.draw();
  }

  /** Where an event is, on the canvas [screen px]. */
  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /** Pixels of the picture, to a tenth of one; what lies beside it comes to its edge. */
  on_picture([x, y]) {
    const tenth = (value, most) => Math.round(10 * Math.min(most, Math.max(0, value))) / 10;
    return [tenth(this.left + x / this.scale, this.picture.cols), tenth(this.top + y / this.scale, this.picture.rows)];
  }

  /** Soon, and once for all that has changed. */
  draw() {
    if (this.is_due) return;
    this.is_due = true;
    requestAnimationFrame(() => {
      this.is_due = false;
      this.draw_now();
    });
  }

  draw_now() {
    const { pen, canvas } = this;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    if (!this.photo) return;
    const scale = this.scale * this.ratio;
    pen.setTransform(scale, 0, 0, scale, -this.left * scale, -this.top * scale);
    pen.imageSmoothingEnabled = scale < 2;
    pen.drawImage(this.photo, 0, 0, this.picture.cols, this.picture.rows);
    if (this.mask) this.draw_mask();
    if (this.shows_strokes) {
      this.strokes.forEach((stroke, i) => this.draw_stroke(stroke, this.erased.has(i) ? 0.2 : 0.9));
      this.passing.forEach((stroke) => this.draw_stroke(stroke, 0.9));
    }
    if (this.current) this.draw_stroke(this.current, 0.9);
    if (this.ruler) this.draw_ruler(this.ruler);
  }

  draw_mask() {
    const { pen, mask } = this;
    const lay = (sheet, opacity) => {
      pen.globalAlpha = opacity;
      pen.drawImage(sheet, mask.x, mask.y, mask.cols * mask.step_x, mask.rows * mask.step_y);
    };
    lay(mask.phases, this.opacity);
    if (this.opacity > 0) lay(mask.lines, Math.min(1, 0.4 + this.opacity));
    if (this.shows_uncertain) lay(mask.doubts, 0.9);
    pen.globalAlpha = 1;
  }

  draw_stroke({ phase, width, points }, opacity) {
    const { pen } = this;
    const line = (colour, more) => {
      pen.strokeStyle = colour;
      pen.lineWidth = Math.max(width, 2 / this.scale) + more / this.scale;
      pen.beginPath();
      pen.moveTo(...points[0]);
      points.forEach((point) => pen.lineTo(...point));
      pen.stroke();
    };
    pen.lineCap = pen.lineJoin = "round";
    pen.globalAlpha = opacity;
    line(phase === "cut" ? "#ffffff" : "#000000", 2);
    line(this.colour_of(phase), 0);
    pen.globalAlpha = 1;
  }

  draw_ruler(points) {
    const { pen } = this;
    for (const [colour, width] of [["#000000", 5], ["#ffe600", 2.5]]) {
      pen.strokeStyle = pen.fillStyle = colour;
      pen.lineWidth = width / this.scale;
      pen.beginPath();
      points.forEach((point) => pen.lineTo(...point));
      pen.stroke();
      for (const [x, y] of points) {
        pen.beginPath();
        pen.arc(x, y, width / this.scale, 0, 2 * Math.PI);
        pen.fill();
      }
    }
  }

  /** Numbers of the strokes that come within a few screen pixels of a point of the picture. */
  strokes_at([x, y]) {
    const distance = ([x0, y0], [x1, y1]) => {
      const [dx, dy] = [x1 - x0, y1 - y0];
      const square = dx * dx + dy * dy;
      const along = square > 0 ? Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / square)) : 0;
      return Math.hypot(x - x0 - along * dx, y - y0 - along * dy);
    };
    const is_near = ({ width, points }) => points.some((point, i) =>
      distance(points[Math.max(0, i - 1)], point) <= width / 2 + 3 / this.scale);
    return this.strokes.flatMap((stroke, i) => (is_near(stroke) ? [i] : []));
  }
}
