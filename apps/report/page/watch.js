// Keeps the page up with the run that its server computes.

class Watch {
  /** @param page  what bring_to_life() resolves to. */
  constructor(page) {
    this.page = page;
    const part = (name) => document.getElementById("watch-" + name);
    this.done = part("done");
    this.words = part("words");
    this.stop_button = part("stop");
    this.number = Number(document.getElementById("watch").dataset.number);
    this.unanswered = 0;
    this.stop_button.addEventListener("click", () => this.stop());
  }

  /** Asks until the run is over, or nobody answers any more. */
  async follow() {
    while (await this.ask()) await new Promise((next) => setTimeout(next, 500));
    this.stop_button.hidden = true;
  }

  /** Resolves to whether the run goes on. */
  async ask() {
    try {
      const answer = await fetch(`now?have=${this.number}`, { cache: "no-store" });
      this.unanswered = 0;
      return answer.status === 200 ? await this.take(await answer.json()) : true;
    } catch {
      if (++this.unanswered < 6) return true;
      this.words.textContent = "The program no longer answers; this is the last state it sent.";
      return false;
    }
  }

  async take(update) {
    this.number = update.number;
    this.done.value = update.fraction;
    if (!this.stopping || !update.goes_on) this.words.textContent = update.words;
    this.done.hidden = !update.goes_on;
    for (const [name, html] of Object.entries(update.parts)) document.getElementById("part-" + name).innerHTML = html;
    await this.page.grow(update);
    return update.goes_on;
  }

  async stop() {
    this.stop_button.disabled = true;
    this.stopping = true;
    this.words.textContent = "Stopping …";
    try {
      await fetch("stop", { method: "POST" });
    } catch {
      this.words.textContent = "The program does not answer.";
    }
  }
}

living.then((page) => new Watch(page).follow());
