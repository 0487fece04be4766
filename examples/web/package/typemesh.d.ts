// SPDX-License-Identifier: MIT

/**
 * typemesh in WebAssembly: text in, triangle meshes out.
 *
 *     import load from "typemesh";
 *     const typemesh = await load();
 *     const font = typemesh.font(new Uint8Array(await (await fetch("DejaVuSans.ttf")).arrayBuffer()));
 *     const mesh = typemesh.mesh("Hello world!", font, {depth: 0.2, bevel: {width: 0.02}});
 *     geometry.setAttribute("position", new THREE.BufferAttribute(mesh.copy().position, 3));  // three.js keeps it
 *
 * What the library refuses throws a TypemeshError, whose message is one sentence; a value of the wrong type, an unknown
 * name of an option, or a font, mesher or mesh that has ended throws a TypeError. load() rejects with an Error.
 * Meshes are right-handed, y up, and face +z; triangles are counter-clockwise seen from outside; v is 0 at the bottom.
 * Places in a text are indices into the string, as of `charCodeAt`.
 */

/**
 * Loads the module. Takes the address of `typemesh.wasm`, its bytes, a compiled module or a Response; by default the file
 * beside `typemesh.js`, in browsers and in node. Each call makes an instance of its own, with its own memory; what
 * belongs to one cannot be given to another.
 */
export default function load(source?: string | URL | ArrayBuffer | Uint8Array | WebAssembly.Module | Response): Promise<Typemesh>;
export { load };

export interface Typemesh {
    /** The version of the library, "0.1.0". */
    readonly version: string;

    /**
     * The names and values of all options, with their defaults, as the library has them: for pages that make their
     * controls of it. `bevel.width` stands for `{bevel: {width: ...}}`.
     */
    readonly options: readonly OptionDescription[];

    /** Opens a font: TrueType, OpenType (CFF, CFF2), a collection of them. WOFF and WOFF2 are to be unpacked before. The bytes are copied. */
    font(bytes: ArrayBuffer | Uint8Array, options?: FontOptions): Font;

    /**
     * The mesh of a text, made by a mesher that is kept for these fonts. Ends the mesh before it that was made for the
     * same fonts, as Mesher.mesh() does. Bytes instead of a font are opened at the first call with this very object and
     * kept as long as it lives; fonts in a list stand in for what those before them lack.
     */
    mesh(text: string, fonts: Fonts, options?: MeshOptions): Mesh;

    /** A mesher of your own, for text that changes often, or for several meshes at a time. */
    mesher(fonts: Fonts, options?: MeshOptions): Mesher;

    /** The contours of a text as its mesh has them, after flattening and filling, at z = 0: `mesh(...).contours()`. */
    outlines(text: string, fonts: Fonts, options?: MeshOptions): Float32Array;

    /**
     * A number of the mesh, 16 hexadecimal digits: FNV-1a, 64 bits, of the bytes of position, normal, uv and index, one
     * after the other. The native program examples/web/mesh_hash prints the same for the same text: `mesh(...).hash()`.
     */
    hash(text: string, fonts: Fonts, options?: MeshOptions): string;

    /** Bytes of the module's memory. It grows to what the largest text needs, and never shrinks. */
    readonly memoryBytes: number;
}

export type Fonts = Font | Uint8Array | ArrayBuffer | readonly (Font | Uint8Array | ArrayBuffer)[];

export interface FontOptions {
    /** Which face of a collection; 0 by default. */
    index?: number;
    /** Of a variable font: {wght: 700, wdth: 80}. */
    variations?: Record<string, number>;
}

export interface Font {
    readonly unitsPerEm: number;
    readonly glyphCount: number;
    /** How many faces the file has. */
    readonly faceCount: number;
    /** Family and style, as the font names itself in English; "" where it does not. */
    readonly family: string;
    readonly style: string;
    /** The axes of a variable font. */
    readonly axes: readonly { tag: string; name: string; minimum: number; default: number; maximum: number }[];
    /** Whether the font has a glyph for each character of the text. */
    has(text: string): boolean;
    /** Gives its memory back, once no mesher uses it any more. Also done when the garbage collector finds it. */
    free(): void;
}

/** Lengths are in em, unless another unit is named. */
export interface MeshOptions {
    /** How large an em is in your world; 1. */
    size?: number;
    /** Of the solid; 0.2. 0 makes a flat mesh: only the front, without bevels. */
    depth?: number;
    /** A preset of the tolerance: 1/100, 1/160, 1/800 (default), 1/16000 em. */
    quality?: "low" | "normal" | "high" | "best";
    /** The largest distance between a curve and the mesh; instead of `quality`. */
    tolerance?: number;
    /** "certified" (default) keeps the tolerance; the others are the thesis', and keep none. */
    discretiser?: "certified" | "two_lines" | "adaptive";
    /** "monotone" (default) is fastest; "delaunay" avoids slender triangles. */
    triangulator?: "monotone" | "delaunay";
    /** "font" (default): the rule of the font's format. */
    fill?: "font" | "non_zero" | "even_odd";
    /** Normals of the walls; "curve" by default. Bevels have their own. */
    normals?: "curve" | "creased" | "averaged" | "shared" | "cap";
    /** Edges that turn by more than this, in degrees, are creases; by default as the style of normals has it. */
    crease?: number;
    /** What texture coordinates are: em along the faces (default), [0, 1] over the text's box, or once round each edge. */
    uv?: "em" | "box" | "cylindrical";
    bevel?: {
        /** 0, the default: no bevel. */
        width?: number;
        /** As `width` by default. */
        depth?: number;
        profile?: "chamfer" | "round" | "concave" | "stepped" | "engraved" | "points";
        /** Of "points": [x, y, x, y, ...], from the wall (0, 0) inwards: shares of the width and of the depth. */
        points?: readonly number[];
        /** Of "round" and "concave"; 0, the default: by the tolerance. */
        steps?: number;
        /** What becomes of bevels too wide for a stroke: they meet in a ridge ("clip", default), or are narrowed for the letter, or for all letters. */
        mode?: "clip" | "fit" | "fit_text";
        sides?: "both" | "front" | "back";
        /** Put on instead of carved in. */
        outward?: boolean;
    };
    /** How far edges are moved outwards; negative makes letters thinner. */
    embolden?: number;
    outline?: {
        /** Of a ring along the edges; 0, the default: none. */
        width?: number;
        place?: "inner" | "outer" | "centre";
        /** Whether the letter within the ring is made as well, in the parts "letter_front" and so on. */
        letter?: boolean;
    };
    /**
     * Bends the text in space; one of `cylinder`, `radius`, `twist` and `wave`. Caps and walls get the points that this needs, so
     * that the mesh keeps the tolerance; letters are built anew each time, and letters() has a mesh for each of them. Not for rings. A text that is bent too tightly is refused.
     */
    bend?: {
        /**
         * Degrees of an upright cylinder that the text goes around, as on a cup; its middle stays where it is. Negative: it is read from
         * the inside. At most 360.
         */
        cylinder?: number;
        /** The cylinder's radius instead: the place x = 0 stays where it is. Negative: as above. */
        radius?: number;
        /** Degrees from the first letter to the last, around the text's middle line. */
        twist?: number;
        /** Height of one wave towards the reader, as long as the text. */
        wave?: number;
    };
    /** Warps the outlines in the plane before all else, so that bevels, rings and walls follow; one of `arc` and `flag`. Also with `bend` or `inflate`. */
    warp?: {
        /** Degrees of a circular arc that the text stands on; negative: a bowl. At most 360. */
        arc?: number;
        /** Height of one wave up and down, as long as the text. */
        flag?: number;
    };
    /** Letters stand on a curve, whose middle is the middle of the text; one of them, and without `warp`. Letters of joined scripts are bent along it. What does not fit is left out. */
    path?: {
        /** The radius of a ring in em, centred at the origin; negative: inside it. */
        ring?: number;
        /** Height of waves, each 6 em long. */
        wave?: number;
    };
    /** Letters like balloons. Not with bevels, rings or `bend`. */
    inflate?: {
        /** In halves of a stroke's width: 1 makes strokes round; 0, the default: not inflated. */
        height?: number;
        /** Front and back, or the front on walls of `depth`. */
        form?: "balloon" | "dome";
    };
    /** Neon letters: round tubes along the outline. Not with bevels, rings, `inflate` or `bend`; `depth` is without effect. */
    tube?: {
        /** In em, at most; what is too narrow for it gets thinner tubes. 0, the default: no tubes. */
        radius?: number;
    };
    /** Letters that meet become one solid. By default only if they have bevels, rings or moved edges, are inflated or tubes. */
    merge?: boolean;

    /** Where lines end; no width by default: only where the text demands it. Columns: their height. */
    width?: number;
    wrap?: "word_or_grapheme" | "word" | "grapheme" | "none";
    /** Lines without a width stand to the right of x = 0, round it, or to its left. */
    align?: "start" | "end" | "left" | "centre" | "right" | "justify";
    /** What is stretched in justified lines. */
    justify?: "auto" | "spaces" | "letters" | "kashida";
    /** Of lines: each as it comes ("first_fit", default), or all of a paragraph as even as can be. */
    breaker?: "first_fit" | "total_fit";
    /** What stands at y = 0. */
    anchor?: "first_baseline" | "last_baseline" | "top" | "middle" | "bottom";
    direction?: "automatic" | "ltr" | "rtl" | "ttb";
    /** Between letters, besides their advances; by default as much as letters have become wider by `embolden`, `outline` and `tube`. */
    letterSpacing?: number;
    /** Times the font's own. */
    lineSpacing?: number;
    indent?: number;
    /** Further lines are dropped, and `ellipsis` stands for them. */
    maxLines?: number;
    ellipsis?: string;
    /** OpenType features: {smcp: 1, liga: 0}. */
    features?: Record<string, number | boolean>;
    /** BCP 47: "tr", "zh-Hant". */
    language?: string;
    /** ISO 15924: "Arab"; by default as the text has it. */
    script?: string;

    /**
     * true reads tags in the text: `[b]bold[/b]`, `[size=1.5]`, `[colour=#c33]`, `[i] [u] [s] [sup] [sub] [rise] [spacing] [depth] [bevel]
     * [mark] [ruby] [lang]`, `[font=2]` (the second font), `[/]` closes the last, `[[` is a bracket. A mistake is refused, with its place.
     * Colours are in `mesh.tint`.
     */
    markup?: boolean;
    /** true tells each vertex its letter: `mesh.letter` and `mesh.letters`. */
    letters?: boolean;
    /** false builds every letter of this mesh anew, for measurements; true by default. */
    cached?: boolean;
}

export interface OptionDescription {
    readonly name: string;
    readonly kind: "number" | "boolean" | "choice" | "string" | "numbers" | "features";
    /** Of a choice; the first one is the default. */
    readonly choices?: readonly string[];
    /** Of a number or a boolean; none where it follows from other options. */
    readonly default?: number | boolean;
}

/** Turns texts into meshes; keeps fonts, options, built letters and all memory. */
export interface Mesher {
    /** Changes the options that are named; the others stay. `undefined` as a value is that option's default. */
    set(options: MeshOptions): this;

    /**
     * The mesh of a text. `options` are only for this text. After a text as long and with the same letters nothing is
     * allocated any more in the module, and letters that were built before are not built again.
     *
     * The mesh ends with the next call of mesh(), letters(), morph() or free() of this mesher, or of at() of its morph.
     */
    mesh(text: string, options?: MeshOptions): Mesh;

    /** The same as different letters and where they stand, for instanced drawing. Letters are not merged. Ends as mesh() does. */
    letters(text: string, options?: MeshOptions): Letters;

    /**
     * Plans a text that moves along an axis of the mesher's first font, such as "wght", with the same triangles: they are proven to
     * hold at every place of the axis, not only at samples. A font that replaces glyphs on the way has several stretches of its axis,
     * each with triangles of its own. `depth`, `size`, `quality`, `tolerance`, `align`, `anchor`, `lineSpacing` and what shapes the text
     * hold; everything else does not, nor do the mesher's other fonts. Lines end only at line ends of the text. With `markup` tags are
     * read and have no effect. A few milliseconds for each different letter; the next morph() of this mesher ends it.
     */
    morph(text: string, axis: string, options?: MeshOptions): Morph;

    /** Forgets all letters that were built. */
    clear(): void;

    /** Gives all memory back to the module. */
    free(): void;
}

/**
 * A finished mesh. Its arrays are views of the module's own memory: nothing is copied. So they
 *
 *   - may be read until the mesh ends (see Mesher.mesh()). Copy what must live longer: `mesh.position.slice()`;
 *   - are to be read from the mesh each time (`mesh.position`), not kept: when the module's memory grows, for whatever
 *     call, the browser detaches all views that were made before (they have length 0), and the mesh makes new ones.
 *
 * A mesh that has ended throws when its arrays are read.
 */
export interface Mesh {
    /** x, y, z of each vertex. */
    readonly position: Float32Array;
    /** Of unit length. */
    readonly normal: Float32Array;
    /** u, v. */
    readonly uv: Float32Array;
    /** Three a triangle. */
    readonly index: Uint32Array;
    /** With the option `letters` the number of each vertex's letter in `letters`; else empty. */
    readonly letter: Uint32Array;
    /** With the option `letters` what can move alone: graphemes, ligatures, letters that are written together or were merged, in reading order. Then underlines and other bars, whose word is -1 unless they go with one word. */
    readonly letters: readonly { readonly pivot: readonly [number, number, number]; readonly word: number; readonly line: number }[];
    /** With the option `markup`: red, green, blue of each vertex, and 0, or 255 where no tag gives a colour; else empty. */
    readonly tint: Uint8Array;
    /** Together all the triangles. Empty parts are left out; with tags such as [b] there may be several of a name. */
    readonly parts: readonly Part[];
    /** Of all positions. Of an empty mesh all are 0. */
    readonly bounds: { readonly low: readonly [number, number, number]; readonly high: readonly [number, number, number] };
    readonly statistics: Statistics;
    /** What is missing or was left out, as sentences; none in most cases. */
    readonly warnings: readonly string[];

    /** How many directed edges are not met by their reverse: 0 for a closed mesh. Takes about as long as the mesh did; vertices in the same place count as one, within each glyph. A flat mesh is open along its contours. */
    openEdges(): number;
    /** The contours of the front as segments: x, y, z of both ends, one after the other. Lives as the arrays do. */
    contours(): Float32Array;
    /** Of Typemesh.hash(). */
    hash(): string;
    /** A copy that lives for itself, outside the module. */
    copy(): { position: Float32Array; normal: Float32Array; uv: Float32Array; index: Uint32Array; parts: Part[] };
}

export interface Part {
    readonly name: "front" | "back" | "side" | "front_bevel" | "back_bevel" | "letter_front" | "letter_back" | "letter_side";
    /** Into `index`: a multiple of 3. */
    readonly start: number;
    readonly count: number;
    /** The vertices that the part has of its own; bevels, and walls with the normals "shared" or "cap", also use vertices of their neighbours. */
    readonly firstVertex: number;
    readonly vertexCount: number;
}

export interface Statistics {
    readonly vertices: number;
    readonly triangles: number;
    readonly glyphs: number;
    /** Lines of the text. */
    readonly lines: number;
    /** How long the longest line is, in em: from the pen at its first letter to the pen behind its last. */
    readonly advance: number;
    /** Characters that no font has. */
    readonly missing: number;
    /** Glyphs left out. */
    readonly refused: number;
    /** Glyphs whose bevel, ring or emboldening had to be narrowed. */
    readonly narrowed: number;
    /** Points of all contours. */
    readonly contourPoints: number;
    /** How long it took, from the string to the finished arrays. As exact as the browser's clock. */
    readonly microseconds: number;
    /** How much of that was shaping, building and placing; the rest was writing. */
    readonly planMicroseconds: number;
}

/** A text as instances: `meshes[mesh[i]]` stands at `translation[3 * i]` and the two after it. The arrays live as long as the arrays of a Mesh. */
export interface Letters {
    readonly position: Float32Array;
    readonly normal: Float32Array;
    readonly uv: Float32Array;
    /** Counted from the vertices' begin, not from the letter's. */
    readonly index: Uint32Array;
    /** The different letters. `glyph` is a number in a font: letters of several fonts or sizes may have the same. */
    readonly meshes: readonly { readonly glyph: number; readonly parts: readonly Part[] }[];
    /** Which letter each instance is. */
    readonly mesh: Uint32Array;
    readonly translation: Float32Array;
    readonly statistics: Statistics;
    readonly warnings: readonly string[];
}

/** A text that moves along an axis of its font: `for each frame: show(morph.at(weight))`. */
export interface Morph {
    /** The ends of the axis. */
    readonly minimum: number;
    readonly maximum: number;
    /** The mesh at a value, which takes microseconds; it ends with the next mesh of this mesher. It has no letters, and u and v are x and y in em. */
    at(value: number): Mesh;
}

/** What the library refuses. */
export class TypemeshError extends Error {
    readonly name: "TypemeshError";
    /** Where in the string, if it is about a place. */
    readonly at?: number;
}
