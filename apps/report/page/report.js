// Brings the page to life; without this script its still pictures and charts stand as they are.

/** All that moves on the page. */
class Page {
  static async of(data) {
    const page = new Page();
    page.data = data;
    page.moment = { x: null };
    const film = data.film && (await Film.of(data.film));
    page.stage = film && new FilmStage(film, data.strain, page.moment);
    const pick = page.stage ? (x) => page.stage.go_to(x / page.data.strain.per_strain) : null;
    page.charts = Object.entries(data.charts).filter(([id]) => document.getElementById("chart-" + id)).map(
        ([id, chart]) => new LiveChart(id, chart, page.moment, id === "sieve" ? null : pick));
    if (page.stage) {
      page.stage.moved = () => page.charts.forEach((chart) => chart.redraw());
      page.stage.go_to(data.film.end_strain);
    }
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => page.charts.forEach((chart) => chart.plot && chart.build()));
    page.buttons = new CurveButtons(page.charts.find((chart) => chart.id === "stress"));
    await page.buttons.offer(data.csv);
    document.documentElement.dataset.alive = "yes";
    return page;
  }

  /** Shows more of the run. @param update  strain, csv, charts and film as in the data of the page. */
  async grow(update) {
    this.data.strain = update.strain;
    if (update.film && !this.stage) return location.reload();  // it began before there was anything to see
    if (update.film) {
      const film = await this.stage.film.grown(update.film);
      this.stage.follow(film, update.strain);
    }
    for (const chart of this.charts)
      if (update.charts[chart.id]) chart.follow(update.charts[chart.id]);
    await this.buttons.offer(update.csv);
  }
}

/** The controls of the film. */
class FilmStage {
  constructor(film, strain_unit, moment) {
    this.film = film;
    this.strain_unit = strain_unit;
    this.moment = moment;
    this.moved = () => {};
    this.strain = 0;
    const part = (name) => document.getElementById("film-" + name);
    this.slider = part("strain");
    this.play_button = part("play");
    this.at = part("at");
    this.readout = part("readout");
    this.counts = part("counts");
    this.legend = part("legend");
    this.look = part("look");
    document.getElementById("film").hidden = false;
    part("screen").style.aspectRatio = `${film.data.cols} / ${film.data.rows}`;
    this.screen = new FilmScreen(film, part("screen"));
    this.slider.addEventListener("input", () => this.go_to((this.film.data.end_strain * this.slider.value) / this.slider.max));
    this.look.addEventListener("change", () => this.show());
    this.play_button.addEventListener("click", () => (this.playing ? this.stop() : this.play()));
    part("whole").addEventListener("click", () => {
      this.screen.whole();
      this.screen.draw();
    });
    part("png").addEventListener("click", async () => save(await film_as_png(this.film), `damage_${this.file_strain()}.png`));
    part("gif").addEventListener("click", () => this.save_gif(part("gif")));
    this.listen_to_pointer(part("screen"));
    this.listen_to_keys(part("screen"));
    new ResizeObserver(() => this.screen.draw()).observe(part("screen"));
  }

  strain_text() {
    return `${rounded(this.strain * this.strain_unit.per_strain)} ${this.strain_unit.name}`;
  }

  file_strain() {
    return this.strain_text().replace("%", "percent").replace(/[^\w.]+/g, "_");
  }

  /** Puts a longer film in place of this one, and goes on to its end where this one was at its own. */
  follow(film, strain_unit) {
    const was_at_end = this.strain >= this.film.data.end_strain;
    this.film = film;
    this.screen.film = film;
    this.strain_unit = strain_unit;
    this.go_to(was_at_end ? film.data.end_strain : this.strain);
  }

  go_to(strain) {
    const end = this.film.data.end_strain;
    this.strain = Math.min(end, Math.max(0, strain));
    this.slider.value = Math.round((this.slider.max * this.strain) / end);
    this.moment.x = this.strain * this.strain_unit.per_strain;
    const failed = this.film.counts(this.strain);
    this.counts.textContent = `${grouped(failed[tension])} ${failed[tension] === 1 ? "pixel" : "pixels"} failed in tension, ${grouped(failed[shear])} in shear`;
    this.at.textContent = this.strain_text();
    this.slider.setAttribute("aria-valuetext", this.strain_text());
    this.show();
    this.moved();
  }

  show() {
    this.film.paint(this.strain, this.look.value);
    this.screen.draw();
    if (this.legend.dataset.look !== this.look.value) this.draw_legend();
  }

  draw_legend() {
    this.legend.dataset.look = this.look.value;
    const { phases, tension: cracked, shear: crushed } = this.film.data;
    const there = new Set(this.film.labels);
    const lines = [[cracked, "failed in tension"], [crushed, "failed in shear"],
                   ...phases.filter((_, label) => there.has(label)).map((phase) => [phase, phase.name])];
    this.legend.replaceChildren(...lines.map(([looks, name]) => {
      const line = document.createElement("span");
      const square = document.createElement("i");
      line.className = "swatch";
      square.style.background = looks[this.look.value];
      line.append(square, name);
      return line;
    }));
  }

  /** From here to the end in eight seconds for the whole; from the beginning when it is at the end. */
  play() {
    const from = this.strain >= this.film.data.end_strain ? 0 : this.strain;
    const begun = performance.now();
    this.playing = true;
    this.play_button.textContent = "Pause";
    const step = (now) => {
      if (!this.playing) return;
      const end = this.film.data.end_strain;
      this.go_to(from + (end * Math.max(0, now - begun)) / 8000);
      if (this.strain >= end) this.stop();
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  stop() {
    this.playing = false;
    this.play_button.textContent = "Play";
  }

  async save_gif(button) {
    const words = button.textContent;
    button.disabled = true;
    const bytes = await film_as_gif(this.film, this.look.value, 60, (share) => {
      button.textContent = `Drawing, ${Math.round(100 * share)} %`;
    });
    save(new Blob([bytes], { type: "image/gif" }), "damage.gif");
    button.textContent = words;
    button.disabled = false;
  }

  /** Place of an event on the canvas, in its own pixels. */
  place(event) {
    const canvas = this.screen.canvas;
    const share = canvas.width / canvas.clientWidth;
    return { x: event.offsetX * share, y: event.offsetY * share };
  }

  listen_to_pointer(canvas) {
    let held = null;
    canvas.addEventListener("pointerdown", (event) => {
      held = this.place(event);
      canvas.setPointerCapture(event.pointerId);
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (held = null));
    canvas.addEventListener("pointermove", (event) => {
      const now = this.place(event);
      if (held && event.buttons !== 0) {
        this.screen.move(held.x - now.x, held.y - now.y);
        this.screen.draw();
        held = now;
      }
      const pixel = this.screen.pixel_at(now.x, now.y);
      if (pixel) this.readout.textContent = this.film.describe(pixel.row, pixel.col, this.strain_unit);
    });
    canvas.addEventListener("wheel", (event) => {
      const { x, y } = this.place(event);
      const before = this.screen.zoom;
      this.screen.zoom_at(Math.exp(-0.002 * event.deltaY), x, y);
      if (this.screen.zoom !== before) event.preventDefault();  // at either end the page scrolls on
      this.screen.draw();
    }, { passive: false });
  }

  listen_to_keys(canvas) {
    canvas.addEventListener("keydown", (event) => {
      const [middle_x, middle_y] = [canvas.width / 2, canvas.height / 2];
      const way = 0.1 * canvas.width;
      const does = {
        "+": () => this.screen.zoom_at(1.5, middle_x, middle_y),
        "=": () => this.screen.zoom_at(1.5, middle_x, middle_y),
        "-": () => this.screen.zoom_at(1 / 1.5, middle_x, middle_y),
        "0": () => this.screen.whole(),
        ArrowLeft: () => this.screen.move(-way, 0),
        ArrowRight: () => this.screen.move(way, 0),
        ArrowUp: () => this.screen.move(0, -way),
        ArrowDown: () => this.screen.move(0, way),
        " ": () => (this.playing ? this.stop() : this.play()),
      }[event.key];
      if (!does || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      does();
      this.screen.draw();
    });
  }
}

/** What the reader takes of the curve. */
class CurveButtons {
  constructor(stress) {
    if (!stress || !stress.plot) return;
    this.row = document.createElement("p");
    this.row.className = "controls";
    this.add("Save as PNG", async () => save(await chart_as_png(stress), "curve.png"));
    stress.place.append(this.row);
  }

  add(words, act) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = words;
    button.addEventListener("click", act);
    this.row.prepend(button);
  }

  /** The table, where there is one; a run that goes on has none. */
  async offer(csv) {
    if (!csv || !this.row) return;
    const table = await inflated(csv);
    this.add("Save as CSV", () => save(new Blob([table], { type: "text/csv" }), "curve.csv"));
  }
}

/** The chart on the paper of the page. */
function chart_as_png(chart) {
  const from = chart.plot.ctx.canvas;
  const canvas = document.createElement("canvas");
  canvas.width = from.width;
  canvas.height = from.height;
  const context = canvas.getContext("2d");
  context.fillStyle = ink("paper");
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(from, 0, 0);
  return new Promise((done) => canvas.toBlob(done, "image/png"));
}

/** The page once it moves; never, in a browser that is too old for it. */
const living = typeof DecompressionStream === "function"
    ? Page.of(JSON.parse(document.getElementById("data").textContent)) : new Promise(() => {});
