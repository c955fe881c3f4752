// The film of the damage: a picture of the specimen at any strain, from the strains at which its pixels failed.

const no_failure = 0, tension = 1, shear = 2;  // as in the map of modes

function channels(hex) {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
}

class Film {
  /** @param data  the film of report_data. */
  static async of(data) {
    const film = new Film();
    const [labels, strength] = await Promise.all([data.labels, data.strength].map((text) => (text ? inflated(text) : null)));
    film.labels = new Uint8Array(labels);
    film.strength = strength && new Uint16Array(strength);
    film.picture = document.createElement("canvas");
    film.picture.width = data.cols;
    film.picture.height = data.rows;
    return film.take(data);
  }

  async take(data) {
    const [failure, mode, crush] = await Promise.all(
        [data.failure, data.mode, data.crush].map((text) => (text ? inflated(text) : null)));
    this.data = data;
    this.failure = new Float32Array(failure);
    this.mode = new Uint8Array(mode);
    this.crush = crush && new Float32Array(crush);
    return this;
  }

  /** The film of the same specimen further on in its run; this one stays as it is. */
  grown(growth) {
    return Object.assign(new Film(), this).take({ ...this.data, ...growth });
  }

  /** How a pixel has failed at a strain [-]; the maps hold strains in 32 bits, and are compared so. */
  mode_at(pixel, strain) {
    const now = Math.fround(strain);
    if (this.crush && this.crush[pixel] <= now) return shear;
    return this.failure[pixel] <= now ? this.mode[pixel] : no_failure;
  }

  /** Colours [r, g, b] of the phases, then of tension and shear. */
  palette(look) {
    return [...this.data.phases, this.data.tension, this.data.shear].map((one) => channels(one[look]));
  }

  /** Number in the palette of each pixel. */
  indices(strain) {
    const failed = this.data.phases.length - 1;
    const result = new Uint8Array(this.labels.length);
    for (let pixel = 0; pixel < result.length; ++pixel) {
      const mode = this.mode_at(pixel, strain);
      result[pixel] = mode === no_failure ? this.labels[pixel] : failed + mode;
    }
    return result;
  }

  /** How many pixels have failed at a strain, by mode. */
  counts(strain) {
    const counts = [0, 0, 0];
    for (let pixel = 0; pixel < this.labels.length; ++pixel) ++counts[this.mode_at(pixel, strain)];
    return counts;
  }

  paint(strain, look) {
    const palette = this.palette(look);
    const indices = this.indices(strain);
    const image = new ImageData(this.data.cols, this.data.rows);
    for (let pixel = 0; pixel < indices.length; ++pixel) {
      image.data.set(palette[indices[pixel]], 4 * pixel);
      image.data[4 * pixel + 3] = 255;
    }
    this.picture.getContext("2d").putImageData(image, 0, 0);
  }

  /** What a pixel is, and what became of it. */
  describe(row, col, strain_unit) {
    const pixel = row * this.data.cols + col;
    const phase = this.data.phases[this.labels[pixel]];
    const size = this.data.pixel_mm;
    const in_unit = (strain) => rounded(strain * strain_unit.per_strain) + " " + strain_unit.name;
    const words = [`x ${rounded((col + 0.5) * size)} mm, y ${rounded((this.data.rows - row - 0.5) * size)} mm: ${phase.name}`];
    if (this.strength && this.strength[pixel] > 0) {
      const factor = this.strength[pixel] * this.data.strength_unit;
      if (phase.tensile_MPa !== null) words.push(`tensile strength ${rounded(factor * phase.tensile_MPa)} MPa`);
      if (phase.cohesion_MPa !== null) words.push(`cohesion ${rounded(factor * phase.cohesion_MPa)} MPa`);
    }
    if (phase.tensile_MPa === null && phase.cohesion_MPa === null) return words.join("; ");
    const mode = this.mode[pixel];
    words.push(mode === no_failure ? "did not fail"
                                   : `failed in ${mode === tension ? "tension" : "shear"} at ${in_unit(this.failure[pixel])}`);
    if (this.crush && Number.isFinite(this.crush[pixel])) words.push(`crushed at ${in_unit(this.crush[pixel])}`);
    return words.join("; ");
  }
}

/** The window on the film: which part of it is seen, and how large. */
class FilmScreen {
  constructor(film, canvas) {
    this.film = film;
    this.canvas = canvas;
    this.whole();
  }

  whole() {
    this.zoom = 1;
    this.left = 0;  // of the part that is seen, in pixels of the film
    this.top = 0;
  }

  /** Screen pixels of the canvas to a pixel of the film. */
  scale() {
    return (this.zoom * this.canvas.width) / this.film.data.cols;
  }

  zoom_at(factor, x, y) {
    const before = this.scale();
    this.zoom = Math.min(64, Math.max(1, this.zoom * factor));
    this.left += x / before - x / this.scale();
    this.top += y / before - y / this.scale();
    this.keep_inside();
  }

  move(right, down) {
    this.left += right / this.scale();
    this.top += down / this.scale();
    this.keep_inside();
  }

  keep_inside() {
    const { cols, rows } = this.film.data;
    this.left = Math.min(Math.max(0, this.left), cols - cols / this.zoom);
    this.top = Math.min(Math.max(0, this.top), rows - rows / this.zoom);
  }

  /** Row and column under a place of the canvas, or null. */
  pixel_at(x, y) {
    const col = Math.floor(this.left + x / this.scale());
    const row = Math.floor(this.top + y / this.scale());
    const { cols, rows } = this.film.data;
    return row >= 0 && row < rows && col >= 0 && col < cols ? { row, col } : null;
  }

  draw() {
    const { cols, rows } = this.film.data;
    const width = Math.round(this.canvas.clientWidth * devicePixelRatio);
    if (width > 0 && this.canvas.width !== width) {
      this.canvas.width = width;
      this.canvas.height = Math.round((width * rows) / cols);
    }
    const context = this.canvas.getContext("2d");
    context.imageSmoothingEnabled = this.scale() < 1;
    context.drawImage(this.film.picture, this.left, this.top, cols / this.zoom, rows / this.zoom, 0, 0,
                      this.canvas.width, this.canvas.height);
    this.draw_scale_bar(context);
  }

  /** A bar of 1, 2 or 5 times a power of ten, a fifth of the picture at most. */
  draw_scale_bar(context) {
    const millimetre = this.scale() / this.film.data.pixel_mm;
    const most = (0.2 * this.canvas.width) / millimetre;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].map((one) => one * power).find((one) => one <= most);
    const text = `${rounded(length)} mm`;
    const unit = devicePixelRatio;
    const [x, y, bar] = [12 * unit, this.canvas.height - 14 * unit, length * millimetre];
    context.font = `${13 * unit}px system-ui, sans-serif`;
    const box = Math.max(bar, context.measureText(text).width) + 12 * unit;
    context.fillStyle = "rgba(255, 255, 255, 0.85)";
    context.fillRect(x - 6 * unit, y - 22 * unit, box, 30 * unit);
    context.fillStyle = "#000";
    context.fillRect(x, y, bar, 3 * unit);
    context.fillText(text, x, y - 6 * unit);
  }
}
