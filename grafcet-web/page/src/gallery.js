// Charts to open: those of the repository, as they were when the page was built.

let shelves = null;

export async function charts() {
  shelves ??= fetch("gallery.json").then(response => {
    if (!response.ok) throw new Error(`gallery.json: ${response.status}`);
    return response.json();
  });
  return shelves;
}

export class Gallery {
  #dialog = document.getElementById("gallery");
  #find = document.getElementById("find");
  #place = document.getElementById("shelves");
  #open;

  // `open` gets the text of the chart that was chosen.
  constructor(open) {
    this.#open = open;
    document.getElementById("open-gallery").addEventListener("click", () => this.show());
    this.#find.addEventListener("input", () => this.#filter());
  }

  async show() {
    this.#dialog.showModal();
    this.#find.focus();
    if (this.#place.childElementCount > 0) return;
    try {
      this.#place.replaceChildren(...(await charts()).map(shelf => this.#shelf(shelf)));
    } catch (error) {
      shelves = null;
      this.#place.textContent = error.message;
    }
    this.#filter();
  }

  #shelf({ title, charts }) {
    const shelf = document.createElement("section"), heading = document.createElement("h3"), list = document.createElement("ul");
    heading.textContent = title;
    for (const { name, about, text } of charts) {
      const item = document.createElement("li"), button = document.createElement("button"), line = document.createElement("span");
      button.type = "button";
      const strong = document.createElement("strong");
      strong.textContent = name;
      line.textContent = about;
      button.append(strong, line);
      button.addEventListener("click", () => {
        this.#dialog.close();
        this.#open(text);
      });
      item.dataset.words = `${name} ${about}`.toLowerCase();
      item.append(button);
      list.append(item);
    }
    shelf.append(heading, list);
    return shelf;
  }

  #filter() {
    const wanted = this.#find.value.trim().toLowerCase();
    for (const item of this.#place.querySelectorAll("li")) item.hidden = !item.dataset.words.includes(wanted);
    for (const shelf of this.#place.querySelectorAll("section")) shelf.hidden = [...shelf.querySelectorAll("li")].every(item => item.hidden);
  }
}
