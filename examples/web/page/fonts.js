// SPDX-License-Identifier: MIT
// Which fonts a text is set in: the chosen one, and for what it lacks those that come with the page, fetched as they are needed.

/** Letters of scripts as a regular expression; of "Emoji" all that Unicode draws as pictures. */
export const lettersOf = scripts => new RegExp(`[${scripts.map(s => s === "Emoji" ? "\\p{Extended_Pictographic}\\p{Regional_Indicator}" : `\\p{Script=${s}}`).join("")}]`, "gu");

const hasFailed = entry => !entry.font && performance.now() < entry.tryAgain;

/**
 * An entry of the list has a name, and bytes or a way to get them: load(), which may be slow or fail. With `letters`, a regular
 * expression, it is the page's font for those letters and comes before the others.
 */
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

    /** Takes the text that is to be set, for the page's own fonts of its scripts; true if list() changes. */
    suit(text) {
        const before = this.#suiting.filter(e => e.font), has = this.used?.font.has?.bind(this.used.font) ?? (() => false);
        this.#suiting = this.#entries.filter(e => e.letters && e !== this.used && !hasFailed(e) && [...new Set(text.match(e.letters))].some(c => !has(c)));
        const now = this.#suiting.filter(e => e.font);
        return now.length !== before.length || now.some((e, i) => e !== before[i]);
    }
    #suiting = [];

    /** Whether a font of the text's scripts has yet to come. */
    get awaits() { return this.#suiting.some(e => !e.font && !hasFailed(e)); }

    /**
     * Opens one more of those that come with the page: first the fonts of the text's scripts, then, if letters are missing all the
     * same, the others in their order. False when there is none, undefined when a font was chosen meanwhile.
     */
    async openAnother(areMissing = true) {
        const turn = this.#turn, [some, others] = [this.#entries.filter(e => !e.letters), this.#entries.filter(e => e.letters)];
        for (const entry of areMissing ? [...this.#suiting, ...some, ...others] : this.#suiting) {
            if (!entry.load || hasFailed(entry) || (entry.font && (entry.stands || entry === this.used))) continue;
            await this.#opened(entry).catch(() => { entry.tryAgain = performance.now() + 30000; });
            if (turn !== this.#turn) return undefined;
            entry.stands = entry.font !== undefined;
            if (entry.stands) return true;
        }
        return false;
    }

    /** The fonts to set a text in: the same for the same text, whatever was chosen and fetched before it. */
    list() {
        return [(this.#of === this.used && this.#weighed) || this.used.font, ...this.#standing.map(e => e.font)];
    }
    get #standing() {
        const standing = this.#entries.filter(e => e !== this.used && e.stands && !this.#suiting.includes(e));
        return [...this.#suiting.filter(e => e.font), ...standing.filter(e => !e.letters), ...standing.filter(e => e.letters)];
    }

    /** The files of the fonts that a text needs besides the chosen one. */
    othersFor(text) {
        const lacking = [...new Set(text.replace(/[\s\p{C}\p{Variation_Selector}]/gu, ""))].filter(c => !this.used.font.has(c)), files = [];
        for (const entry of this.#standing) {
            const own = lacking.filter(c => entry.font.has(c));
            if (own.length > 0) files.push(entry.file);
            own.forEach(c => lacking.splice(lacking.indexOf(c), 1));
        }
        return files;
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
        if (entry.font) return;
        entry.coming ??= entry.bytes ? Promise.resolve(entry.bytes) : entry.load();  // one request, whoever asks again meanwhile
        try {
            const bytes = await entry.coming;
            entry.font ??= this.#open(entry.bytes = bytes);
        } finally {
            entry.coming = undefined;  // the next one who needs it tries again
        }
    }
}
