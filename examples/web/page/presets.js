// SPDX-License-Identifier: MIT
// What the page shows off: each is a link, with everything that differs from the page's start.

const column = "春は曙\n夏は夜\n冬は雪";
const word = (colour, text) => `[colour=${colour}]${text}[/]`;
const scripts = `[size=1.3]${word("#ffd23f", "Hello")} ${word("#ff4d6d", "שלום")}[/]\n${word("#ff9f1c", "★")} ${word("#5aa2ff", "こんにちは")} ${word("#ff4d6d", "♥")}\n[size=1.3]${word("#2ee6c5", "नमस्ते")} ${word("#ff9f1c", "مرحبا")}[/]`;
const sign = `${word("#ff2e88", "open all night")} ${word("#29e0ff", "•")} ${word("#29e0ff", "open all night")} ${word("#ff2e88", "•")} `;
const poster = "[size=1.8][depth=0.35][colour=#e4432d]DEEP[/][/][/]\u00a0 [depth=0.04]flat[/]\n[mark=#ffc400]\u00a0marked\u00a0[/] [u][colour=#0a7d5a]under[/][/]\n[ruby=small above][colour=#0b57d0]ruby[/][/] [i]E=mc[sup]2[/][/]";

/** name: of the class that dresses its link; claim: what is said while it is shown, with {triangles} where the mesh's number stands. */
export const presets = [
    { name: "chrome", label: "Chrome", title: "A headline in chrome",
      claim: "Bevels narrow where strokes are thin, and never fold: {triangles} triangles, 0 open edges",
      set: { text: "CHROME", "page.finish": "chrome", "page.world": "dusk", "page.weight": 900, "bevel.width": 0.06, depth: 0.3, "bevel.mode": "fit" } },
    { name: "balloons", label: "Balloons", title: "Letters blown up like foil balloons",
      claim: "Letters of any font inflate: {triangles} triangles, round and closed",
      set: { text: "PARTY!", "page.finish": "foil", "page.world": "dusk", "page.rainbow": 1, "page.weight": 900, "inflate.height": 1.3, "page.motion": "wave", letterSpacing: 0.06, merge: 0, "bevel.width": 0 } },
    { name: "neon", label: "Neon", title: "Neon tubes along outlines, on a ring",
      claim: "Each outline becomes one closed tube of glass, on a ring or any path",
      set: { text: sign, "page.finish": "neon", "page.world": "night", "page.weight": 500, "path.ring": 2.5, letterSpacing: 0.019, "bevel.width": 0, "tube.radius": 0.016 } },
    { name: "arabic", label: "خط", title: "Arabic calligraphy in gold",
      claim: "Joined Arabic letters become one closed solid: no inner walls",
      set: { text: "سلام", font: "Amiri (Arabic)", "page.finish": "gold", "page.world": "dark", "bevel.width": 0.06, "bevel.profile": "chamfer", quality: "best", embolden: 0.02 } },
    { name: "column", label: "縦書き", title: "Japanese in columns",
      claim: "Columns from right to left, as Japanese books have them: 0 open edges",
      set: { text: column, font: "Sawarabi Mincho (Japanese)", direction: "ttb", "page.finish": "lacquer", "page.world": "light", "bevel.width": 0.02, embolden: 0.02, depth: 0.14, lineSpacing: 0.65 } },
    { name: "flag", label: "Flag", title: "A flag that waves",
      claim: "Cloth and letters are one mesh: the vertex shader is the wind",
      set: { text: "[mark=#1b3a8c]\u00a0AHOY!\u00a0\u00a0\u00a0[/]", "page.colour": "#ffffff", "page.motion": "flag", "bend.wave": 0.2, depth: 0.14, "bevel.width": 0.02 } },
    { name: "breathe", label: "Breathe", title: "A variable font, any weight, one mesh",
      claim: "Every weight from 100 to 900 in one mesh: the same {triangles} triangles, only their corners move",
      set: { text: "breathe", "page.motion": "breathe", "page.finish": "gloss", "page.colour": "#2ec4b6", depth: 0.24, "bevel.width": 0 } },
    { name: "score", label: "1984", title: "A score that rolls up like a mileage counter",
      claim: "40 digits on 4 wheels, one mesh: a shader rolls them, no upload per frame",
      set: { text: "1984", "page.motion": "score", "page.finish": "lacquer", "page.world": "light", "page.weight": 900, "page.colour": "#ffb000", depth: 0.12, "bevel.width": 0.02 } },
    { name: "scripts", label: "Aあبअ", title: "Five scripts and symbols in one text",
      claim: "Five scripts, two directions, one call, shaped by HarfBuzz: {triangles} triangles",
      set: { text: scripts, font: "DejaVu Sans", "page.finish": "gloss", "page.world": "dark", "page.colour": "#ffd23f", embolden: 0.034, "bevel.width": 0.02, lineSpacing: 0.8 } },
    { name: "tags", label: "[tags]", title: "Tags in the text",
      claim: "Tags in the text are geometry: depth, marks, underlines, ruby",
      set: { text: poster, "page.world": "light", "page.colour": "#23262d", depth: 0.16, "bevel.width": 0.016, lineSpacing: 1.12 } },
    { name: "ribbon", label: "Twist", title: "A bevelled line of text, twisted",
      claim: "Bent within a proven tolerance, bevels too: {triangles} triangles, still closed",
      set: { text: "[mark=#a3123a]\u00a0\u00a0TWIST\u00a0\u00a0[/]", "bend.twist": 160, "page.weight": 900, "page.finish": "gold", "page.world": "light", "bevel.width": 0.02, depth: 0.12 } },
];

/** Whether two links set the same, in whatever order. */
const sorted = link => [...new URLSearchParams(link)].map(String).sort().join("&");
export const isSame = (one, other) => sorted(one) === sorted(other);

export const linkOf = preset => "#" + new URLSearchParams(preset.set);
