// SPDX-License-Identifier: MIT
// Which fonts a text is set in: the chosen one, and for what it lacks those that come with the page.

/** An entry of the list has a name, and bytes or a way to get them: load(), which may be slow or fail. */
export class Fonts {
    #open;
    #entries = [];
    #turn = 0;

    /** open(bytes) makes a font. */
    constructor(open) { this.#open = open; }

    used = undefined;  // the chosen entry, once it is open

    /** Adds an entry, or replaces the one of that name; true if it is new. */
    offer(entry) {
        const at = this.#entries.findIndex(e => e.name === entry.name);
        if (at < 0) this.#entries.push(entry);
        else this.#entries[at] = entry;
        return at < 0;
    }
    /** The entry of a name, or else the first. */
    find(name) { return this.#entries.find(e => e.name === name) ?? this.#entries[0]; }
    get first() { return this.#entries[0]; }

    /** Opens the entry and makes it the chosen one; false if another was chosen meanwhile, whose turn it then is. */
    async choose(entry) {
        const turn = ++this.#turn;
        try {
            await this.#opened(entry);
        } catch (e) {
            if (turn === this.#turn) throw e;
            return false;
        }
        if (turn !== this.#turn) return false;
        this.used = entry;
        return true;
    }

    /** Opens one more of those that come with the page; false when there is none, or when another font was chosen meanwhile. */
    async openAnother() {
        const turn = this.#turn;
        for (const entry of this.#entries) {
            if (!entry.load || entry.font || entry.failed) continue;
            await this.#opened(entry).catch(() => { entry.failed = true; });
            if (turn !== this.#turn) return false;
            if (entry.font) return true;
        }
        return false;
    }

    /** The fonts to set a text in. */
    list() {
        const others = this.#entries.filter(e => e !== this.used && e.load && e.font);
        return [(this.#of === this.used && this.#weighed) || this.used.font, ...others.map(e => e.font)];
    }

    /** The weight axis of the chosen font, or undefined. */
    get weights() { return this.used?.font.axes?.find(axis => axis.tag === "wght"); }
    /** Sets the chosen font at a weight, if it has weights; true if list() changes. */
    weigh(wanted) {
        const axis = this.weights, value = axis && Math.min(axis.maximum, Math.max(axis.minimum, wanted));
        if (this.#of === this.used && this.#weight === value) return false;
        this.#weighed?.free();
        this.#weighed = this.#of = undefined;  // what follows may fail
        this.#weighed = axis && value !== axis.default ? this.#open(this.used.bytes, { variations: { wght: value } }) : undefined;
        this.#of = this.used;
        this.#weight = value;
        return true;
    }
    #weighed;
    #weight;
    #of;  // the entry that is weighed

    async #opened(entry) {
        if (!entry.font) entry.font = this.#open(entry.bytes ??= await entry.load());
        return entry.font;
    }
}
