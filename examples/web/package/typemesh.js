// SPDX-License-Identifier: MIT

// The face of typemesh.wasm, for browsers and node; what each name does stands in typemesh.d.ts.

export class TypemeshError extends Error {
    constructor(message, at) {
        super(message);
        this.name = 'TypemeshError';
        if (at !== undefined) this.at = at;
    }
}

const nowhere = 0xFFFFFFFF;

async function compile(source) {
    if (source instanceof WebAssembly.Module) return source;
    if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
    const isAddress = typeof source === 'string' || source instanceof URL;
    const address = source === undefined ? new URL('typemesh.wasm', import.meta.url) : source;
    const isFile = source === undefined ? address.protocol === 'file:' : isAddress && /^file:/.test(String(source));
    const isInNode = typeof process === 'object' && process.versions?.node;
    if (isInNode && (isFile || (typeof source === 'string' && !/^[a-z]+:/i.test(source)))) {
        const { readFile } = await import('node:fs/promises');
        return WebAssembly.compile(await readFile(address));
    }
    const response = address instanceof URL || typeof address === 'string' ? await fetch(address) : address;
    if (!response.ok) throw new Error(`${response.url || address} cannot be loaded: ${response.status} ${response.statusText}`);
    return WebAssembly.compile(await response.arrayBuffer());
}

export async function load(source) {
    const module = await compile(await source);
    return new Typemesh(module);
}
export default load;

/** A module with its memory. Views are made anew whenever the memory has grown, which detaches those before. */
class Machine {
    constructor(module) {
        const imports = {};
        for (const { module: from, name } of WebAssembly.Module.imports(module)) {
            imports[from] ??= {};
            imports[from][name] = () => 0;
        }
        imports.wasi_snapshot_preview1 = {
            ...imports.wasi_snapshot_preview1,
            clock_time_get: (clock, precision, place) => {
                const time = BigInt(Math.round(performance.now() * 1e6));
                new DataView(this.memory.buffer).setBigUint64(place, time, true);
                return 0;
            },
            proc_exit: (status) => {
                throw new Error(`typemesh.wasm has ended with the status ${status}.`);
            },
        };
        this.calls = null;
        this.calls = new WebAssembly.Instance(module, imports).exports;
        this.memory = this.calls.memory;
        this.buffer = null;
        this.calls._initialize?.();
    }

    get bytes() {
        this.renew();
        return this.u8;
    }
    get words() {
        this.renew();
        return this.u32;
    }
    get floats() {
        this.renew();
        return this.f32;
    }
    renew() {
        if (this.buffer === this.memory.buffer) return;
        this.buffer = this.memory.buffer;
        this.u8 = new Uint8Array(this.buffer);
        this.u16 = new Uint16Array(this.buffer);
        this.u32 = new Uint32Array(this.buffer);
        this.f32 = new Float32Array(this.buffer);
    }

    take(size) {
        const at = this.calls.malloc(size || 1) >>> 0;
        if (at === 0) throw new TypemeshError('The module has no more memory: free some fonts or meshers.');
        return at;
    }
    give(at) {
        this.calls.free(at);
    }

    /** Copies bytes into memory of their own. */
    put(bytes) {
        const at = this.take(bytes.length);
        this.bytes.set(bytes, at);
        return at;
    }
    putWords(words) {
        const at = this.take(4 * words.length);
        this.words.set(words, at >>> 2);
        return at;
    }

    /** A text that ends with a zero, in UTF-8. */
    read(at) {
        const bytes = this.bytes;
        at >>>= 0;
        return decoder.decode(bytes.subarray(at, bytes.indexOf(0, at)));
    }

    /** What the last call has refused. */
    failure() {
        const at = (this.calls.web_failure() >>> 0) >>> 2;
        const place = this.words[at + 1];
        return new TypemeshError(this.read(this.words[at]), place === nowhere ? undefined : place);
    }
}

const decoder = new TextDecoder();

/** Four letters as a number. */
function tagOf(name) {
    if (typeof name !== 'string' || !/^[\x20-\x7e]{4}$/.test(name))
        throw new TypeError(`"${name}" is not a tag: a tag has four letters, digits or spaces.`);
    return ((name.charCodeAt(0) << 24) | (name.charCodeAt(1) << 16) | (name.charCodeAt(2) << 8) | name.charCodeAt(3)) >>> 0;
}
const tagName = (tag) => String.fromCharCode(tag >>> 24, (tag >>> 16) & 255, (tag >>> 8) & 255, tag & 255);

const isBytes = (value) => value instanceof ArrayBuffer || value instanceof Uint8Array;
const bytesOf = (value) => (value instanceof Uint8Array ? value : new Uint8Array(value));

class Typemesh {
    #machine;
    #options;
    #fonts = new WeakMap(); // of bytes
    #meshers = new WeakMap(); // of the first font: a list of those with further ones

    constructor(module) {
        this.#machine = new Machine(module);
        const calls = this.#machine.calls;
        this.version = this.#machine.read(calls.web_version());
        this.#options = this.#machine
            .read(calls.web_options())
            .trimEnd()
            .split('\n')
            .map((line) => {
                const [name, kind, choices, usual] = line.split('\t');
                const described = { name, kind };
                if (kind === 'choice') described.choices = Object.freeze(choices.split('|'));
                if (kind === 'number' && usual !== '') described.default = Number(usual);
                if (kind === 'boolean' && usual !== '') described.default = usual === '1';
                return Object.freeze(described);
            });
        Object.freeze(this.#options);
        this.#machine.table = new OptionTable(this.#options);
        this.#machine.partNames = this.#machine.read(calls.web_part_names()).split(' ');
    }

    get options() {
        return this.#options;
    }
    get memoryBytes() {
        return this.#machine.memory.buffer.byteLength;
    }

    font(bytes, options = {}) {
        if (!isBytes(bytes)) throw new TypeError('The bytes of a font must be an ArrayBuffer or a Uint8Array.');
        return new Font(this.#machine, bytesOf(bytes), options);
    }

    mesher(fonts, options) {
        const mesher = new Mesher(this.#machine, this.#fontsOf(fonts));
        return options === undefined ? mesher : mesher.set(options);
    }

    mesh(text, fonts, options) {
        return this.#mesherOf(fonts).mesh(text, options ?? {});
    }
    outlines(text, fonts, options) {
        return this.mesh(text, fonts, options).contours();
    }
    hash(text, fonts, options) {
        return this.mesh(text, fonts, options).hash();
    }

    #fontsOf(fonts) {
        const list = Array.isArray(fonts) ? fonts : [fonts];
        if (list.length === 0) throw new TypeError('A text needs at least one font.');
        return list.map((one) => {
            if (one instanceof Font) return one;
            if (!isBytes(one)) throw new TypeError('A font must be a Font, an ArrayBuffer or a Uint8Array.');
            let font = this.#fonts.get(one);
            if (font === undefined) this.#fonts.set(one, (font = this.font(one)));
            return font;
        });
    }

    #mesherOf(fonts) {
        const list = this.#fontsOf(fonts);
        let known = this.#meshers.get(list[0]);
        if (known === undefined) this.#meshers.set(list[0], (known = []));
        let found = known.find((k) => k.fonts.length === list.length && k.fonts.every((f, i) => f === list[i]));
        if (found === undefined) {
            found = { fonts: list, mesher: new Mesher(this.#machine, list) };
            known.push(found);
            if (known.length > 4) known.shift().mesher.free(); // fallback lists that are no longer used
        }
        return found.mesher;
    }
}

/** Gives memory of the module back when the object that it belongs to is no longer used. */
const lost = new FinalizationRegistry((close) => close());

class Font {
    #machine;
    #handle;
    #facts;

    constructor(machine, bytes, { index = 0, variations = {} }) {
        this.#machine = machine;
        const axes = Object.entries(variations).map(([tag, value]) => [tagOf(tag), Number(value)]);
        const places = machine.take(8 * axes.length);
        try {
            const at = machine.put(bytes); // web_open_font() takes them, also where it fails
            axes.forEach(([tag, value], i) => {
                machine.words[(places >>> 2) + 2 * i] = tag;
                machine.floats[(places >>> 2) + 2 * i + 1] = value;
            });
            this.#handle = machine.calls.web_open_font(at, bytes.length, index, places, axes.length) >>> 0;
        } finally {
            machine.give(places);
        }
        if (this.#handle === 0) throw machine.failure();
        lost.register(this, ((calls, handle) => () => calls.web_close_font(handle))(machine.calls, this.#handle), this);
        this.#facts = this.#read();
    }

    #read() {
        const machine = this.#machine;
        const at = (machine.calls.web_font_facts(this.#handle) >>> 0) >>> 2;
        const [unitsPerEm, glyphCount, faceCount, family, style, axes, count] = machine.words.slice(at, at + 7);
        const facts = { unitsPerEm, glyphCount, faceCount, family: machine.read(family), style: machine.read(style), axes: [] };
        for (let i = 0; i < count; ++i) {
            const one = (axes >>> 2) + 5 * i;
            const [minimum, usual, maximum] = machine.floats.slice(one + 1, one + 4);
            const [tag, name] = [machine.words[one], machine.words[one + 4]];
            facts.axes.push({ tag: tagName(tag), name: machine.read(name), minimum, default: usual, maximum });
        }
        return facts;
    }

    /** For meshers. */
    handleIn(machine) {
        if (machine !== this.#machine) throw new TypeError('Another instance of typemesh opened this font: open it again.');
        if (this.#handle === 0) throw new TypeError('The font has been freed: open it again.');
        return this.#handle;
    }

    get unitsPerEm() {
        return this.#facts.unitsPerEm;
    }
    get glyphCount() {
        return this.#facts.glyphCount;
    }
    get faceCount() {
        return this.#facts.faceCount;
    }
    get family() {
        return this.#facts.family;
    }
    get style() {
        return this.#facts.style;
    }
    get axes() {
        return this.#facts.axes;
    }
    has(text) {
        const handle = this.handleIn(this.#machine);
        for (const character of text)
            if (this.#machine.calls.web_font_has(handle, character.codePointAt(0)) === 0) return false;
        return true;
    }
    free() {
        if (this.#handle === 0) return;
        lost.unregister(this);
        this.#machine.calls.web_close_font(this.#handle);
        this.#handle = 0;
    }
}

/** Finds options by their names, and hands their values over. */
class OptionTable {
    constructor(options) {
        this.byName = new Map(options.map((option, number) => [option.name, { ...option, number }]));
        this.groups = new Set(options.filter((o) => o.name.includes('.')).map((o) => o.name.split('.')[0]));
    }

    /** Adds {bevel: {width: 0.02}} to `flat` as "bevel.width" -> 0.02. */
    gather(options, flat, before = '') {
        for (const [name, value] of Object.entries(options)) {
            const whole = before + name;
            if (before === '' && this.groups.has(name) && !this.byName.has(name)) {
                if (value === undefined || value === null) {
                    for (const known of flat.keys()) if (known.startsWith(name + '.')) flat.delete(known);
                } else if (typeof value === 'object') this.gather(value, flat, name + '.');
                else throw new TypeError(`${whole} is a group of options: write {${name}: {...}}.`);
                continue;
            }
            const option = this.byName.get(whole);
            if (option === undefined) throw new TypeError(`There is no option ${whole}: check its name.`);
            if (value === undefined || value === null) flat.delete(whole);
            else {
                this.check(option, value);
                flat.set(whole, value);
            }
        }
        return flat;
    }

    check(option, value) {
        const refuse = (wanted) => {
            throw new TypeError(`${option.name} must be ${wanted}, not ${JSON.stringify(value) ?? String(value)}.`);
        };
        if (option.kind === 'number' && typeof value !== 'number') refuse('a number');
        if (option.kind === 'boolean' && typeof value !== 'boolean') refuse('true or false');
        if (option.kind === 'string' && typeof value !== 'string') refuse('a string');
        if (option.kind === 'choice' && !option.choices.includes(value)) refuse(`one of ${option.choices.join(', ')}`);
        if (option.kind === 'numbers' && !(Array.isArray(value) && value.every((n) => typeof n === 'number')))
            refuse('an array of numbers');
        if (option.kind === 'features') {
            if (typeof value !== 'object') refuse('an object such as {smcp: 1}');
            Object.keys(value).forEach(tagOf);
        }
    }

    hand(machine, mesher, flat) {
        const calls = machine.calls;
        calls.web_reset(mesher);
        // Presets first, which single values then refine.
        const ordered = flat.has('tolerance') ? [...flat].sort(([a], [b]) => (b === 'quality') - (a === 'quality')) : flat;
        for (const [name, value] of ordered) {
            const { kind, number, choices } = this.byName.get(name);
            if (kind === 'number' || kind === 'boolean') calls.web_set_number(mesher, number, Number(value));
            else if (kind === 'choice') calls.web_set_number(mesher, number, choices.indexOf(value));
            else if (kind === 'numbers') for (const one of value) calls.web_set_number(mesher, number, one);
            else if (kind === 'features')
                for (const [tag, how] of Object.entries(value)) calls.web_add_feature(mesher, tagOf(tag), Number(how));
            else {
                const at = machine.take(2 * value.length);
                machine.renew();
                for (let i = 0; i < value.length; ++i) machine.u16[(at >>> 1) + i] = value.charCodeAt(i);
                calls.web_set_text(mesher, number, at, value.length);
                machine.give(at);
            }
        }
        calls.web_take(mesher);
    }
}

class Mesher {
    #machine;
    #handle;
    #fonts; // as long as the mesher lives
    #own = new Map(); // the options set
    #usesOwn = true; // they are those that the module has
    #text = { at: 0, room: 0 };
    #made = 0; // counts the texts
    #morphs = 0;

    constructor(machine, fonts) {
        this.#machine = machine;
        this.#fonts = fonts;
        const handles = machine.putWords(fonts.map((f) => f.handleIn(machine)));
        this.#handle = machine.calls.web_open_mesher(handles, fonts.length) >>> 0;
        machine.give(handles);
        const text = this.#text;
        const close = ((calls, handle) => () => {
            calls.web_close_mesher(handle);
            if (text.at !== 0) calls.free(text.at);
        })(machine.calls, this.#handle);
        lost.register(this, close, this);
        this.close = close;
    }

    set(options) {
        this.#alive();
        const next = this.#machine.table.gather(options, new Map(this.#own));
        this.#machine.table.hand(this.#machine, this.#handle, next);
        this.#own = next;
        this.#usesOwn = true;
        return this;
    }

    mesh(text, options) {
        return new Mesh(this.#machine, this.#make(text, options, 0));
    }
    letters(text, options) {
        return new Letters(this.#machine, this.#make(text, options, 1));
    }
    morph(text, axis, options) {
        const tag = tagOf(axis);
        const { calls } = this.#machine;
        this.#call(text, options, (at) => calls.web_plan_morph(this.#handle, at, text.length, tag));
        const plan = ++this.#morphs;
        return new Morph(this.#fonts[0].axes.find((a) => a.tag === axis), (value) => {
            if (plan !== this.#morphs) throw new TypeError('The morph is no longer valid, because its mesher has planned another: make it again.');
            return new Mesh(this.#machine, this.#call('', undefined, () => calls.web_write_morph(this.#handle, value), text));
        });
    }
    clear() {
        this.#alive();
        this.#machine.calls.web_clear_cache(this.#handle);
    }
    free() {
        if (this.#handle === 0) return;
        lost.unregister(this);
        this.close();
        this.#handle = 0;
    }

    #alive() {
        if (this.#handle === 0) throw new TypeError('The mesher has been freed: make another.');
    }

    #make(text, options, instances) {
        return this.#call(text, options, (at) => this.#machine.calls.web_make(this.#handle, at, text.length, instances));
    }

    /** Hands options and the text over, calls, and gives where the mesh is. */
    #call(text, options, make, shown = text) {
        this.#alive();
        const begun = performance.now();
        if (typeof text !== 'string') throw new TypeError('The text must be a string.');
        const machine = this.#machine;
        if (options !== undefined) {
            machine.table.hand(machine, this.#handle, machine.table.gather(options, new Map(this.#own)));
            this.#usesOwn = false;
        } else if (!this.#usesOwn) {
            machine.table.hand(machine, this.#handle, this.#own);
            this.#usesOwn = true;
        }
        const status = make(this.#put(text));
        const own = ++this.#made;
        if (status !== 0) throw machine.failure();
        const place = (machine.calls.web_result(this.#handle) >>> 0) >>> 2;
        const microseconds = 1000 * (performance.now() - begun);
        return { mesher: this.#handle, place, text: shown, microseconds, isThere: () => this.#handle !== 0 && this.#made === own };
    }

    #put(text) {
        const machine = this.#machine;
        const kept = this.#text;
        if (kept.room < text.length) {
            if (kept.at !== 0) machine.give(kept.at);
            kept.room = 0;
            kept.at = machine.take(4 * text.length);
            kept.room = 2 * text.length;
        }
        machine.renew();
        const units = machine.u16;
        const first = kept.at >>> 1;
        for (let i = 0; i < text.length; ++i) units[first + i] = text.charCodeAt(i);
        return kept.at;
    }
}

// Where web_mesh of exports.cpp has what, in numbers of 32 bits.
const field = {
    position: 0, normal: 1, uv: 2, index: 3, vertices: 4, triangles: 5, parts: 6, partCount: 7, letters: 8, letterCount: 9,
    instances: 10, translations: 11, instanceCount: 12, bounds: 13, glyphs: 19, lines: 20, contourPoints: 21, missing: 22,
    firstMissing: 23, refused: 24, narrowed: 25, invalidUnits: 26, unbroken: 27, firstRefusal: 28, planMicroseconds: 29,
    letterOf: 30, letterRows: 31, letterRowCount: 32, tints: 33, tintCount: 34, advance: 35,
};

/** What Mesh and Letters have in common. */
class Arrays {
    #machine;
    #made;
    #views = {};
    #statistics;
    #parts;

    constructor(machine, made) {
        this.#machine = machine;
        this.#made = made;
        const [words, floats, at] = [machine.words, machine.floats, made.place];
        this.#statistics = {
            vertices: words[at + field.vertices],
            triangles: words[at + field.triangles],
            glyphs: words[at + field.glyphs],
            lines: words[at + field.lines],
            advance: floats[at + field.advance],
            missing: words[at + field.missing],
            refused: words[at + field.refused],
            narrowed: words[at + field.narrowed],
            contourPoints: words[at + field.contourPoints],
            microseconds: made.microseconds,
            planMicroseconds: floats[at + field.planMicroseconds],
        };
    }

    get position() {
        return this.floats('position', field.position, 3 * this.#statistics.vertices);
    }
    get normal() {
        return this.floats('normal', field.normal, 3 * this.#statistics.vertices);
    }
    get uv() {
        return this.floats('uv', field.uv, 2 * this.#statistics.vertices);
    }
    get index() {
        return this.words('index', field.index, 3 * this.#statistics.triangles);
    }
    get statistics() {
        return this.#statistics;
    }

    get warnings() {
        const [all, machine, s] = [[], this.machine, this.#statistics];
        const number = (name) => machine.words[this.#made.place + field[name]];
        if (s.refused > 0)
            all.push(`${s.refused} of ${s.glyphs} glyphs are left out; this is why the first is: ${machine.read(number('firstRefusal'))}`);
        if (s.missing > 0) {
            const place = number('firstMissing');
            const code = this.#made.text.codePointAt(place), shown = String.fromCodePoint(code ?? 0xFFFD);  // none: a morph keeps no places
            const named = `U+${code?.toString(16).toUpperCase().padStart(4, '0')}${/[\p{L}\p{N}\p{P}\p{S}]/u.test(shown) ? ` ${shown}` : ''}`;
            const first = code === undefined ? '' : `; the first is ${named}, at ${place}`;
            all.push(`No font has a glyph for ${s.missing} of ${s.glyphs} characters${first}. Add another font.`);
        }
        if (number('invalidUnits') > 0) all.push(`The text has half of a character at ${number('invalidUnits')} places.`);
        if (number('unbroken') > 0)
            all.push('Lines of Thai, Lao, Khmer or Burmese end only where they must, because there is no dictionary for their words.');
        if (s.narrowed > 0)
            all.push(`The edges of ${s.narrowed} of ${s.glyphs} glyphs have moved less than their bevel, ring or weight requests.`);
        return all;
    }

    // What the classes below use.

    get machine() {
        if (!this.#made.isThere()) throw new TypeError('The mesh is no longer valid, because its mesher has made another mesh or was freed: make it again.');
        return this.#machine;
    }
    get handle() {
        return this.#made.mesher;
    }
    number(which) {
        return this.machine.words[this.#made.place + which];
    }
    float(which) {
        return this.machine.floats[this.#made.place + which];
    }

    /** A view that is kept until the memory grows. */
    floats(name, which, count) {
        return this.view(Float32Array, name, which, count);
    }
    words(name, which, count) {
        return this.view(Uint32Array, name, which, count);
    }
    view(Type, name, which, count) {
        const { buffer } = this.machine.memory;
        const kept = this.#views[name];
        if (kept !== undefined && kept.buffer === buffer) return kept;
        return (this.#views[name] = new Type(buffer, count === 0 ? 0 : this.number(which), count));
    }

    /** All parts; a letter has some of them. */
    get allParts() {
        if (this.#parts !== undefined) return this.#parts;
        const { words, partNames } = this.machine;
        const at = this.number(field.parts) >>> 2;
        return (this.#parts = Array.from({ length: this.number(field.partCount) }, (_, i) => {
            const [name, start, count, firstVertex, vertexCount] = words.subarray(at + 5 * i, at + 5 * i + 5);
            return { name: partNames[name], start, count, firstVertex, vertexCount };
        }));
    }
}

class Mesh extends Arrays {
    get tint() {
        return this.view(Uint8Array, 'tint', field.tints, 4 * this.number(field.tintCount));
    }
    get letter() {
        const count = this.number(field.letterRowCount) === 0 ? 0 : this.statistics.vertices;
        return this.words('letter', field.letterOf, count);
    }
    get letters() {
        const count = this.number(field.letterRowCount);
        const rows = this.floats('letterRows', field.letterRows, 5 * count);
        return Array.from({ length: count }, (_, i) => {
            const [x, y, z, word, line] = rows.subarray(5 * i, 5 * i + 5);
            return { pivot: [x, y, z], word, line };
        });
    }
    get parts() {
        return this.allParts;
    }
    get bounds() {
        const at = (i) => this.float(field.bounds + i);
        return { low: [at(0), at(1), at(2)], high: [at(3), at(4), at(5)] };
    }
    openEdges() {
        return this.machine.calls.web_open_edges(this.handle) >>> 0;
    }
    contours() {
        const { calls, memory } = this.machine;
        const count = calls.web_find_contours(this.handle) >>> 0;
        return new Float32Array(memory.buffer, count === 0 ? 0 : calls.web_contours(this.handle) >>> 0, count);
    }
    hash() {
        const at = (this.machine.calls.web_hash(this.handle) >>> 0) >>> 2;
        const half = (number) => number.toString(16).padStart(8, '0');
        return half(this.machine.words[at]) + half(this.machine.words[at + 1]);
    }
    copy() {
        const [position, normal, uv, index] = [this.position, this.normal, this.uv, this.index].map((a) => a.slice());
        return { position, normal, uv, index, parts: this.parts.map((p) => ({ ...p })) };
    }
}

/** A text that moves along an axis. */
class Morph {
    #axis;
    #write;

    constructor(axis, write) {
        this.#axis = axis;
        this.#write = write;
    }
    get minimum() {
        return this.#axis.minimum;
    }
    get maximum() {
        return this.#axis.maximum;
    }
    at(value) {
        if (typeof value !== 'number' || !Number.isFinite(value)) throw new TypeError(`A value of an axis must be a number, not ${value}.`);
        return this.#write(value);
    }
}

class Letters extends Arrays {
    get meshes() {
        const { words } = this.machine;
        const at = this.number(field.letters) >>> 2;
        return Array.from({ length: this.number(field.letterCount) }, (_, i) => {
            const [glyph, first, count] = words.subarray(at + 3 * i, at + 3 * i + 3);
            return { glyph, parts: this.allParts.slice(first, first + count) };
        });
    }
    get mesh() {
        return this.words('mesh', field.instances, this.number(field.instanceCount));
    }
    get translation() {
        return this.floats('translation', field.translations, 3 * this.number(field.instanceCount));
    }
}
