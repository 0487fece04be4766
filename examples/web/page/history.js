// SPDX-License-Identifier: MIT
// Undo: states are compared as they are kept, and changes in quick succession are one.

export class History {
    #past = [];
    #future = [];
    #changed = 0;

    now = undefined;

    /** Keeps a state; within a second of the last one it replaces that. */
    keep(state, time = performance.now()) {
        if (JSON.stringify(state) === JSON.stringify(this.now)) return;
        if (this.now === undefined) return void (this.now = state);  // the first one
        if (this.#past.length === 0 || time - this.#changed > 1000) this.#past.push(this.now);
        if (this.#past.length > 200) this.#past.shift();
        this.#changed = time;
        this.#future = [];
        this.now = state;
    }
    /** The state before, or undefined. */
    undo() { return this.#go(this.#past, this.#future); }
    redo() { return this.#go(this.#future, this.#past); }
    get canUndo() { return this.#past.length > 0; }
    get canRedo() { return this.#future.length > 0; }

    #go(from, to) {
        if (from.length === 0) return undefined;
        to.push(this.now);
        this.#changed = 0;
        return (this.now = from.pop());
    }
}
