// The page on which strokes teach a picture: tools, orders to the program, and what it answers.

const by_id = (id) => document.getElementById(id);

class Editor {
  constructor() {
    this.given = JSON.parse(by_id("data").textContent);
    this.desk = new Desk(by_id("canvas"));
    this.desk.colour_of = (phase) => this.colour_of(phase);
    this.own = [];  // names of the person's own phases
    this.state = { number: 0, version: 0, mask_version: 0 };
    this.fingers = new Map();
    this.orders = this.asked = Promise.resolve();
    this.unanswered = 0;
    this.take_tools();
    this.take_pointer();
    this.take_keys();
    this.take_settings();
    this.choose("aggregate");
  }

  // What the program tells ------------------------------------------------------------------------------------------

  /** Asks until the program has ended, or nobody answers any more. */
  async follow() {
    while (await this.ask()) {
      const is_busy = this.state.is_sorting || this.state.is_making;
      await new Promise((next) => setTimeout(next, is_busy ? 100 : 500));
    }
  }

  /** Once the questions before are answered; resolves to whether to ask again. */
  ask() {
    this.asked = this.asked.then(() => this.ask_now());
    return this.asked;
  }

  async ask_now() {
    try {
      const answer = await fetch(`now?have=${this.state.number}`, { cache: "no-store" });
      this.unanswered = 0;
      if (answer.status === 200) await this.take(await answer.json());
    } catch {
      if (++this.unanswered < 6) return true;
      this.end("The program no longer answers. Start it again to go on: your strokes are kept in " + this.state.file);
      return false;
    }
    if (this.state.has_ended) this.end("The program has ended. Your strokes are kept in " + this.state.file);
    return !this.state.has_ended;
  }

  async bytes(name) {
    const answer = await fetch(name, { cache: "no-store" });
    if (!answer.ok) throw new Error(name);
    return new Uint8Array(await answer.arrayBuffer());
  }

  async take(state) {
    const before = this.state;
    if (!this.desk.photo) {
      this.desk.take_photo(state.picture, await this.bytes("photo"));
      this.set_brush(Math.max(3, Math.round(Math.min(state.picture.cols, state.picture.rows) / 150)));
    }
    if (state.version !== before.version) await this.take_strokes();
    if (state.mask_version !== before.mask_version) {
      const mask = state.found && state.found.rows ? await this.bytes("mask") : null;
      if (mask && mask.length === 2 * state.found.rows * state.found.cols)
        this.desk.take_mask(state.found, mask, this.given.colours);
      else this.desk.no_mask();
    }
    this.state = state;
    this.tell();
    document.documentElement.dataset.alive = "yes";
  }

  async take_strokes() {
    const answer = await (await fetch("strokes", { cache: "no-store" })).json();
    this.strokes_version = answer.version;
    this.desk.strokes = answer.strokes;
    this.desk.erased.clear();
    this.desk.passing = this.desk.passing.filter((stroke) => !(stroke.version <= answer.version));
    for (const { phase } of answer.strokes) if (!this.is_known(phase)) this.add_phase(phase);
    this.desk.draw();
  }

  tell() {
    const { state } = this;
    by_id("undo").disabled = !state.can_undo;
    by_id("redo").disabled = !state.can_redo;
    by_id("file").textContent = state.file;
    by_id("status").textContent = this.status();
    for (const field of document.querySelectorAll("#settings [data-key]")) {
      const text = state.settings[field.dataset.key];
      if (field.type === "checkbox") field.checked = text === "true";
      else if (field !== document.activeElement) field.value = text === field.placeholder ? "" : text;
    }
    this.tell_figures(state.found || {});
    const notes = (state.found && state.found.notes) || [];
    by_id("note-list").replaceChildren(...notes.map((note) => this.tag("li", note)));
    by_id("make").disabled = state.is_making || !state.has_scale;
    by_id("made").textContent = this.words_of_made();
    by_id("command").textContent = state.made ? state.made.command : "";
    by_id("command").hidden = !state.made;
  }

  status() {
    const { state } = this;
    const found = state.found || {};
    if (state.is_making) return "Making the specimen …";
    if (state.is_sorting) return "Sorting …";
    if (found.why) return found.why;
    if (!found.rows) return "Choose a phase and draw a stroke on it. Then do the same for another phase.";
    const size = found.factor > 1 ? `a sketch of 1/${found.factor} of its size` : "the picture in its full size";
    const time = found.seconds ? `, in ${found.seconds.toFixed(1)} s` : "";
    return `The mask shows ${size}${time}. Correct it with further strokes where it is wrong.`;
  }

  words_of_made() {
    const { state } = this;
    if (state.fault) return state.fault;
    if (!state.has_scale) return "The scale is not known: give the width of the picture, or use the ruler.";
    if (!state.made) return "";
    const written = "Wrote " + state.made.files.join(", ") + ".";
    return state.made.is_current ? written + " This command makes the same specimen again, without the page:"
      : written + " Strokes or settings have changed since. This command makes it as it was:";
  }

  tell_figures(found) {
    const rows = [];
    const percent = (share) => (100 * share).toFixed(1);
    const { figures } = found;
    if (figures) {
      for (const [phase, { fraction, pixels }] of Object.entries(figures.phases))
        if (pixels > 0) rows.push([phase, percent(fraction), "%"]);
      if (found.uncertain !== null) rows.push(["uncertain", percent(found.uncertain), "%"]);
      const { count, smallest_m, largest_m } = figures.aggregates;
      rows.push(["aggregates", String(count), ""]);
      if (smallest_m) rows.push(["smallest", (1e3 * smallest_m).toPrecision(3), "mm"], ["largest", (1e3 * largest_m).toPrecision(3), "mm"]);
    }
    by_id("figures").replaceChildren(...rows.map(([name, value, unit]) => {
      const row = document.createElement("tr");
      const head = this.tag("th", name), of_unit = this.tag("td", unit);
      head.scope = "row";
      of_unit.className = "unit";
      row.append(head, this.tag("td", value), of_unit);
      return row;
    }));
    this.draw_sieve((figures && figures.aggregates.sieve) || []);
  }

  tag(name, text) {
    const element = document.createElement(name);
    element.textContent = text;
    return element;
  }

  draw_sieve(rows) {
    const svg = by_id("sieve");
    svg.toggleAttribute("hidden", rows.length < 2);
    if (rows.length < 2) return;
    const shape = (name, attributes, text = "") => {
      const element = document.createElementNS("http://www.w3.org/2000/svg", name);
      for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
      element.textContent = text;
      return element;
    };
    const least = rows[0].diameter_m, most = rows[rows.length - 1].diameter_m;
    const x = (diameter) => 38 + (252 * (diameter - least)) / (most - least);
    const y = (passing) => 140 - 130 * passing;
    const word = (at_x, at_y, text, anchor) =>
      shape("text", { x: at_x, y: at_y, "text-anchor": anchor, "font-size": 12, class: "fill-muted" }, text);
    const points = rows.map((row) => `${x(row.diameter_m)},${y(row.passing)}`).join(" ");
    svg.replaceChildren(
      ...[0, 0.5, 1].flatMap((share) => [
        shape("line", { x1: 38, x2: 290, y1: y(share), y2: y(share), class: "stroke-grid" }), word(32, y(share) + 4, 100 * share, "end")]),
      shape("polyline", { points, "stroke-width": 2, class: "stroke-first" }),
      word(38, 157, (1e3 * least).toPrecision(3), "start"), word(290, 157, (1e3 * most).toPrecision(3) + " mm", "end"),
      word(164, 157, "passing in %", "middle"));
  }

  end(words) {
    this.say(words);
    for (const button of document.querySelectorAll("button, input")) button.disabled = true;
    this.has_ended = true;
  }

  say(words) {
    by_id("message").textContent = words;
    by_id("message").hidden = words === "";
  }

  // What the person orders ------------------------------------------------------------------------------------------

  /** Sends orders one after the other; resolves to the answer, or to nothing where it was refused. */
  order(name, content = {}) {
    const send = async () => {
      try {
        const answer = await fetch(name, { method: "POST", body: JSON.stringify(content) });
        const reply = answer.status === 204 ? {} : await answer.json().catch(() => ({}));
        if (!answer.ok) {
          this.say(reply.error || `The program refused this (${answer.status}).`);
          return null;
        }
        this.say("");
        return reply;
      } catch {
        this.say("The program does not answer; this was not done.");
        return null;
      }
    };
    const done = this.orders.then(send);
    this.orders = done.then(() => this.ask());
    return done;
  }

  async add(stroke) {
    this.desk.passing.push(stroke);
    const reply = await this.order("add", { phase: stroke.phase, width: stroke.width, points: stroke.points });
    if (reply) stroke.version = reply.version;
    else this.desk.passing = this.desk.passing.filter((other) => other !== stroke);
    if (reply && this.strokes_version >= stroke.version)
      this.desk.passing = this.desk.passing.filter((other) => other !== stroke);
    this.desk.draw();
  }

  /** Asks for a line of text; resolves to nothing where there is none. */
  question(words, example) {
    by_id("asked-for").textContent = words;
    by_id("answer").value = "";
    by_id("answer").placeholder = example;
    by_id("asked").hidden = false;
    by_id("answer").focus();
    return new Promise((answered) => {
      this.answer = (text) => {
        by_id("asked").hidden = true;
        this.answer = null;
        by_id("canvas").focus();
        answered(text);
      };
    });
  }

  async measure(points) {
    const text = await this.question("Distance between the two points, with its unit:", "25 mm");
    this.desk.ruler = null;
    this.desk.draw();
    if (text === null) return;
    const [, number, unit] = /^\s*([0-9.]+(?:e[-+]?\d+)?)\s*(\S+)\s*$/i.exec(text) || [];
    const metres = { um: 1e-6, "µm": 1e-6, mm: 1e-3, cm: 1e-2, m: 1 }[unit];
    const { picture } = this.state;
    const pixels = Math.hypot(points[1][0] - points[0][0], (points[1][1] - points[0][1]) * picture.aspect);
    if (!metres || !(Number(number) > 0)) return this.say("Write a number and its unit (um, mm, cm or m), such as 25 mm.");
    if (pixels < 2) return this.say("The two points are too near to each other.");
    const cols = picture.crop[2] || picture.cols;
    const width = (1e3 * metres * Number(number) * cols) / pixels;
    this.order("set", { "convert.width": `${Number(width.toPrecision(6))} mm` });
  }

  // Tools -----------------------------------------------------------------------------------------------------------

  is_known(phase) {
    return Boolean(document.querySelector(`[data-tool="${CSS.escape(phase)}"]`));
  }

  /** The colour of its label: the standard ones, then names in the order in which they first came. */
  colour_of(phase) {
    const { given } = this;
    if (phase === "cut") return given.cut;
    if (phase === "one-grain") return given.one_grain;
    const standard = ["void", "aggregate", "mortar", "itz"].indexOf(phase);
    return given.colours[standard >= 0 ? standard : 4 + Math.max(0, this.own.indexOf(phase))];
  }

  add_phase(phase) {
    if (phase !== "itz") this.own.push(phase);
    const key = String(by_id("own-phases").children.length + 4);
    const button = this.tag("button", phase + " ");
    button.type = "button";
    button.className = "tool";
    button.dataset.tool = phase;
    button.dataset.key = key;
    const dot = document.createElement("i");
    dot.style.background = this.colour_of(phase);
    button.prepend(dot);
    if (Number(key) < 10) button.append(this.tag("kbd", key));
    button.addEventListener("click", () => this.choose(phase));
    by_id("own-phases").append(button);
  }

  async ask_for_phase() {
    const phase = await this.question("Name of the phase:", "fibre");
    if (phase === null) return;
    if (!/^[A-Za-z0-9_-]{1,60}$/.test(phase)) return this.say("A phase has a name of letters, digits, _ and -.");
    if (!this.is_known(phase)) this.add_phase(phase);
    this.choose(phase);
  }

  choose(tool) {
    this.tool = tool;
    for (const button of document.querySelectorAll("[data-tool]"))
      button.setAttribute("aria-pressed", String(button.dataset.tool === tool));
    by_id("canvas").dataset.tool = tool;
    this.desk.ruler = null;
    this.desk.draw();
  }

  set_brush(width) {
    by_id("brush").value = width;
    this.width = Math.min(1000, Math.max(1, width));
    by_id("brush-value").textContent = `${this.width} px`;
  }

  set_opacity(percent) {
    by_id("opacity").value = percent;
    by_id("opacity-value").textContent = `${percent} %`;
    this.desk.opacity = percent / 100;
    this.desk.draw();
  }

  take_tools() {
    const on_click = (id, act) => by_id(id).addEventListener("click", act);
    for (const button of document.querySelectorAll("[data-tool]"))
      button.addEventListener("click", () => this.choose(button.dataset.tool));
    on_click("add-phase", () => this.ask_for_phase());
    on_click("undo", () => this.order("undo"));
    on_click("redo", () => this.order("redo"));
    on_click("make", () => this.order("make"));
    on_click("finish", () => this.order("stop"));
    on_click("fit", () => this.desk.fit());
    on_click("zoom-in", () => this.zoom(1.4));
    on_click("zoom-out", () => this.zoom(1 / 1.4));
    by_id("brush").addEventListener("input", (event) => this.set_brush(Number(event.target.value)));
    by_id("opacity").addEventListener("input", (event) => this.set_opacity(Number(event.target.value)));
    by_id("show-uncertain").addEventListener("change", (event) => this.show("shows_uncertain", event.target.checked));
    by_id("show-strokes").addEventListener("change", (event) => this.show("shows_strokes", event.target.checked));
    by_id("asked").addEventListener("submit", (event) => {
      event.preventDefault();
      this.answer(by_id("answer").value.trim());
    });
    on_click("no-answer", () => this.answer(null));
    this.set_brush(9);
    this.set_opacity(45);
  }

  show(what, is_shown) {
    this.desk[what] = is_shown;
    by_id(what === "shows_strokes" ? "show-strokes" : "show-uncertain").checked = is_shown;
    this.desk.draw();
  }

  zoom(factor) {
    const box = by_id("canvas").getBoundingClientRect();
    this.desk.zoom(factor, box.width / 2, box.height / 2);
  }

  take_settings() {
    by_id("settings").addEventListener("submit", (event) => event.preventDefault());
    by_id("settings").addEventListener("change", async ({ target }) => {
      const text = target.type === "checkbox" ? String(target.checked) : target.value.trim() || null;
      if (!(await this.order("set", { [target.dataset.key]: text })) && target.type === "checkbox")
        target.checked = !target.checked;
    });
  }

  // Mouse, pen, fingers ---------------------------------------------------------------------------------------------

  take_pointer() {
    const canvas = by_id("canvas");
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    canvas.addEventListener("pointerup", (event) => this.release(event, true));
    canvas.addEventListener("pointercancel", (event) => this.release(event, false));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.desk.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), ...this.desk.place(event));
    }, { passive: false });
  }

  press(event) {
    if (this.has_ended || !this.desk.photo) return;
    by_id("canvas").focus();
    by_id("canvas").setPointerCapture(event.pointerId);
    const place = this.desk.place(event);
    this.fingers.set(event.pointerId, place);
    if (this.fingers.size > 1) return this.leave();  // two fingers move and zoom
    const is_moving = event.button === 1 || this.holds_space || this.tool === "pan";
    if (event.button !== 0 && !is_moving) return;
    const point = this.desk.on_picture(place);
    this.erased_to = null;
    this.action = is_moving ? "move" : this.tool === "erase" || this.tool === "ruler" ? this.tool : "draw";
    if (this.action === "draw") {
      const is_thin = this.tool === "cut" || this.tool === "one-grain";
      this.desk.current = { phase: this.tool, width: is_thin ? Math.min(this.width, 3) : this.width, points: [point] };
    }
    if (this.action === "erase") this.erase(point);
    if (this.action === "ruler") this.desk.ruler = this.ruler_start ? [this.ruler_start, point] : [point, point];
    this.desk.draw();
  }

  drag(event) {
    if (!this.fingers.has(event.pointerId)) return;
    const before = this.fingers.get(event.pointerId), now = this.desk.place(event);
    if (this.fingers.size === 2) this.pinch(event.pointerId, before, now);
    this.fingers.set(event.pointerId, now);
    if (this.action === "move") this.desk.move(now[0] - before[0], now[1] - before[1]);
    const events = event.getCoalescedEvents ? event.getCoalescedEvents() : [];
    const points = (events.length > 0 ? events : [event]).map((one) => this.desk.on_picture(this.desk.place(one)));
    if (this.action === "draw") points.forEach((point) => this.draw_to(point));
    if (this.action === "erase") points.forEach((point) => this.erase(point));
    if (this.action === "ruler") this.desk.ruler[1] = points[points.length - 1];
    if (this.action) this.desk.draw();
  }

  draw_to(point) {
    const { points } = this.desk.current;
    const [x, y] = points[points.length - 1];
    const step = Math.max(0.5, this.desk.current.width / 8, 1 / this.desk.scale);
    if (Math.hypot(point[0] - x, point[1] - y) >= step) points.push(point);
  }

  /** All along the way, since a fast hand leaves few points. */
  erase(point) {
    const from = this.erased_to || point;
    const steps = Math.ceil((Math.hypot(point[0] - from[0], point[1] - from[1]) * this.desk.scale) / 3) || 1;
    for (let step = 1; step <= steps; ++step) {
      const at = [0, 1].map((axis) => from[axis] + ((point[axis] - from[axis]) * step) / steps);
      for (const number of this.desk.strokes_at(at)) this.desk.erased.add(number);
    }
    this.erased_to = point;
  }

  pinch(id, before, now) {
    const other = [...this.fingers.entries()].find(([finger]) => finger !== id)[1];
    const apart = (place) => Math.hypot(place[0] - other[0], place[1] - other[1]);
    this.desk.move((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    if (apart(before) > 0) this.desk.zoom(apart(now) / apart(before), (now[0] + other[0]) / 2, (now[1] + other[1]) / 2);
  }

  release(event, is_done) {
    if (!this.fingers.delete(event.pointerId)) return;
    const { action } = this;
    const { current, erased, ruler } = this.desk;
    if (!is_done) return this.leave();
    this.action = this.desk.current = null;
    if (action === "draw") this.add(current);
    if (action === "erase" && erased.size > 0)
      this.order("remove", { version: this.strokes_version, strokes: [...erased] }).then((reply) => {
        if (!reply) erased.clear();
        this.desk.draw();
      });
    if (action === "ruler") this.end_ruler(ruler);
    this.desk.draw();
  }

  /** Drawn from one point to the other, or clicked at both. */
  end_ruler(ruler) {
    const is_click = Math.hypot(ruler[1][0] - ruler[0][0], ruler[1][1] - ruler[0][1]) * this.desk.scale < 4;
    if (!this.ruler_start && is_click) {
      this.ruler_start = ruler[0];
      return;
    }
    this.ruler_start = null;
    this.measure(ruler);
  }

  /** What was begun is not done. */
  leave() {
    this.action = this.desk.current = this.desk.ruler = this.ruler_start = null;
    this.desk.erased.clear();
    this.desk.draw();
  }

  take_keys() {
    document.addEventListener("keydown", (event) => this.press_key(event));
    document.addEventListener("keyup", (event) => {
      if (event.key === " ") this.holds_space = false;
    });
  }

  press_key(event) {
    if (this.has_ended) return;
    if (event.key === "Escape") {
      if (this.answer) this.answer(null);
      return this.leave();
    }
    const is_typing = event.target.matches("input[type=text]");
    const key = event.key.toLowerCase();
    if ((event.ctrlKey || event.metaKey) && !is_typing && (key === "z" || key === "y")) {
      event.preventDefault();
      return void this.order(key === "y" || event.shiftKey ? "redo" : "undo");
    }
    if (is_typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const acts = {
      "[": () => this.set_brush(Math.max(1, Math.round(this.width / 1.25))),
      "]": () => this.set_brush(Math.ceil(this.width * 1.25)),
      "+": () => this.zoom(1.4),
      "-": () => this.zoom(1 / 1.4),
      0: () => this.desk.fit(),
      m: () => this.set_opacity(this.desk.opacity > 0 ? 0 : 45),
      u: () => this.show("shows_uncertain", !this.desk.shows_uncertain),
      s: () => this.show("shows_strokes", !this.desk.shows_strokes),
    };
    if (acts[key]) return acts[key]();
    if (key === " " && !event.target.matches("button, summary, input")) {
      event.preventDefault();
      this.holds_space = true;
      return;
    }
    const button = document.querySelector(`[data-tool][data-key="${CSS.escape(key)}"]`);
    if (button) this.choose(button.dataset.tool);
  }
}

const editor = new Editor();
editor.follow();
