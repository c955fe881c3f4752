// The charts of the page, in the place of their still pictures.

function ink(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

/** uPlot keeps one y for each x: what falls upright, as an avalanche does, moves on by less than can be seen. */
function rising(places) {
  let last = -Infinity;
  return places.map((x) => (last = x > last ? x : last + 1e-9 * Math.max(Math.abs(last), 1e-9)));
}

/** Whether a curve goes back, as one that snaps back does. */
function turns(places) {
  return places.some((x, i) => x < places[i - 1]);
}

/** The line through the places of a curve that goes back, which uPlot cannot draw by itself. */
function path_of(plot, { x, y }) {
  const stroke = new Path2D();
  x.forEach((_, i) => stroke.lineTo(plot.valToPos(x[i], "x", true), plot.valToPos(y[i], "y", true)));
  return { stroke };
}

/** Columns with one common x, as uPlot wants them. */
function aligned(series) {
  const all = series.map((one) => rising(one.x));
  const [first] = all;
  const is_common = all.every((places) => places.length === first.length && places.every((x, i) => x === first[i]));
  return is_common ? [first, ...series.map((one) => one.y)] : uPlot.join(series.map((one, i) => [all[i], one.y]));
}

/** A text in lines no wider than a width, as far as its words allow. */
function lines_within(ctx, text, width) {
  const lines = [];
  for (const word of text.split(" ")) {
    const longer = lines.length > 0 ? lines[lines.length - 1] + " " + word : word;
    if (lines.length > 0 && ctx.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/** Between the ticks of numbers of things: 1, 2, 5, 10, 20, ... */
const whole_steps = Array.from({ length: 10 }, (_, k) => [1, 2, 5].map((step) => step * 10 ** k)).flat();

class LiveChart {
  /** @param moment  {strain in the unit of the axis, or null}: drawn as an upright line.
   *  @param pick  called with the x that the reader clicks on; null = clicks do nothing. */
  constructor(id, chart, moment, pick) {
    this.id = id;
    this.place = document.getElementById("chart-" + id);
    this.moment = moment;
    this.pick = pick;
    this.shown = new Set();
    this.take(chart);
    if (this.place && chart.series.length > 0) this.begin();
  }

  take(chart) {
    this.chart = chart;
    this.all = [...chart.series, ...chart.references];
  }

  begin() {
    const figure = this.place.closest(".chart");
    figure.classList.add("is-live");
    figure.hidden = false;
    this.holder = document.createElement("div");
    this.place.append(this.holder);
    this.add_switches();
    this.build();
    new ResizeObserver(() => this.resize()).observe(this.place);
  }

  /** Draws the chart further on in its run; what the reader has zoomed into stays. */
  follow(chart) {
    const before = this.plot && this.outline();
    const whole = this.plot && this.shows_all();
    this.take(chart);
    if (!this.place || chart.series.length === 0) return;
    if (!this.plot) this.begin();
    else if (this.outline() !== before) this.build();
    else {
      this.plot.setData(aligned(this.all), whole);
      if (!whole) this.plot.redraw();
    }
  }

  shows_all() {
    const { data: [x], scales } = this.plot;
    return scales.x.min <= x[0] && scales.x.max >= x[x.length - 1];
  }

  /** What cannot change without a new drawing. */
  outline() {
    return JSON.stringify([this.chart.x, this.chart.y, this.all.map((one) => one.name)]);
  }

  size() {
    const width = Math.max(240, Math.floor(this.place.clientWidth));
    return { width, height: Math.round(Math.min(380, Math.max(220, 0.62 * width))) };
  }

  /** Whether it shows numbers of things, which have no halves. */
  counts() {
    return !this.chart.y.logarithmic && this.all.every((one) => one.y.every((y) => y === null || Number.isInteger(y)));
  }

  build() {
    if (this.plot) this.plot.destroy();
    const straight = uPlot.paths.linear();
    const font = (size) => `${size}px system-ui, sans-serif`;
    const text = { stroke: ink("text"), font: font(13), labelFont: font(this.place.clientWidth < 500 ? 11 : 13) };
    const axis = (from) => ({
      ...text, label: from.label, labelSize: 22, values: (_, ticks) => ticks.map((tick) => (tick === null ? "" : grouped(tick))), grid: { stroke: ink("grid"), width: 1 }, ticks: { stroke: ink("axis"), width: 1 },
    });
    this.plot = new uPlot({
      ...this.size(),
      scales: { x: { time: false, distr: this.chart.x.logarithmic ? 3 : 1 }, y: { distr: this.chart.y.logarithmic ? 3 : 1 } },
      axes: [axis(this.chart.x), { ...axis(this.chart.y), size: 64, ...(this.counts() ? { incrs: whole_steps } : {}) }],
      series: [{ label: this.chart.x.label, value: (_, x) => rounded(x) }, ...this.all.map((one, i) => ({
        label: one.name || this.chart.y.label,
        stroke: ink(one.ink),
        width: 2,
        dash: one.dashed ? [7, 4] : undefined,
        points: { show: false },
        paths: (plot, k, from, to) => (turns(this.all[k - 1].x) ? path_of(plot, this.all[k - 1]) : straight(plot, k, from, to)),
        show: i < this.chart.series.length || this.shown.has(i),
        value: (_, y) => rounded(y),
      }))],
      cursor: { drag: { x: true, y: false } },
      hooks: { setCursor: [(plot) => this.holder.classList.toggle("idle", plot.cursor.idx == null)], draw: [(plot) => this.draw_markers(plot), (plot) => this.draw_moment(plot)] },
    }, aligned(this.all), this.holder);
    this.holder.classList.toggle("idle", this.plot.cursor.idx == null);
    if (this.pick)
      this.plot.over.addEventListener("click", () => {
        if (this.plot.cursor.left >= 0 && this.plot.select.width === 0) this.pick(this.plot.posToVal(this.plot.cursor.left, "x"));
      });
  }

  /** A box for each reference curve, which is off at first. */
  add_switches() {
    if (this.chart.references.length === 0) return;
    const row = document.createElement("p");
    row.className = "controls";
    row.append("Compare with: ");
    this.chart.references.forEach((reference, k) => {
      const label = document.createElement("label");
      const box = document.createElement("input");
      box.type = "checkbox";
      box.addEventListener("change", () => this.show(this.chart.series.length + k, box.checked));
      label.append(box, " " + reference.name);
      row.append(label);
    });
    this.place.append(row);
  }

  show(index, on) {
    if (on) this.shown.add(index);
    else this.shown.delete(index);
    this.plot.setSeries(index + 1, { show: on });
  }

  draw_markers(plot) {
    const { ctx } = plot;
    ctx.save();
    ctx.fillStyle = ink("text");
    ctx.textAlign = "left";
    ctx.textBaseline = "alphabetic";
    ctx.font = `${13 * devicePixelRatio}px system-ui, sans-serif`;
    for (const marker of this.chart.markers) {
      const [x, y] = [plot.valToPos(marker.x, "x", true), plot.valToPos(marker.y, "y", true)];
      ctx.beginPath();
      ctx.arc(x, y, 3.5 * devicePixelRatio, 0, 2 * Math.PI);
      ctx.fill();
      const gap = 8 * devicePixelRatio;
      const lines = lines_within(ctx, marker.text, plot.bbox.width);
      const width = Math.max(...lines.map((line) => ctx.measureText(line).width));
      const beside = x + gap + width <= plot.bbox.left + plot.bbox.width ? x + gap : x - gap - width;
      const line_height = 16 * devicePixelRatio;
      const first = Math.max(line_height, y - gap - (lines.length - 1) * line_height);
      lines.forEach((line, i) => ctx.fillText(line, Math.max(plot.bbox.left, beside), first + i * line_height));
    }
    ctx.restore();
  }

  draw_moment(plot) {
    if (this.moment.x === null || !this.pick) return;
    const x = Math.round(plot.valToPos(this.moment.x, "x", true)) + 0.5;
    const { left, top, width, height } = plot.bbox;
    if (x < left || x > left + width) return;
    plot.ctx.save();
    plot.ctx.strokeStyle = ink("muted");
    plot.ctx.lineWidth = 1;
    plot.ctx.setLineDash([]);
    plot.ctx.beginPath();
    plot.ctx.moveTo(x, top);
    plot.ctx.lineTo(x, top + height);
    plot.ctx.stroke();
    plot.ctx.restore();
  }

  redraw() {
    if (this.plot) this.plot.redraw(false);
  }

  resize() {
    const size = this.size();
    if (this.plot && (size.width !== this.plot.width || size.height !== this.plot.height)) this.plot.setSize(size);
  }
}
