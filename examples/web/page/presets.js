// SPDX-License-Identifier: MIT
// What the page shows off: each is a link, with everything that differs from the page's start.

const column = "春はあけぼの\nやうやう白く\nなりゆく山際";
const scripts = "Hello שלום\nनमस्ते مرحبا\nこんにちは 🚀🎉";

/** name: of the class that dresses its link. */
export const presets = [
    { name: "chrome", label: "Chrome", title: "A headline in chrome: its bevels grow narrower where a stroke is too thin for them", set: { text: "CHROME", "page.finish": "chrome", "page.world": "dusk", "page.weight": 900, "bevel.width": 0.06, depth: 0.3, "bevel.mode": "fit" } },
    { name: "balloons", label: "Balloons", title: "Letters blown up like foil balloons, each a closed mesh of its own", set: { text: "party!", "page.finish": "gloss", "page.rainbow": 1, "inflate.height": 1.2, "page.motion": "wave", letterSpacing: 0.1, merge: 0, "bevel.width": 0 } },
    { name: "neon", label: "Neon", title: "Neon: one closed tube along each outline, on a ring", set: { text: "open all night · open all night · ", "page.finish": "neon", "page.world": "night", "page.weight": 600, "path.ring": 2.25, "bevel.width": 0, "tube.radius": 0.018 } },
    { name: "arabic", label: "خط", title: "Arabic calligraphy: letters that join become one solid, with the ridges of a reed pen", set: { text: "سلام", font: "Amiri (Arabic)", "page.finish": "gold", "page.world": "dark", "bevel.width": 0.06, "bevel.profile": "chamfer", embolden: 0.02 } },
    { name: "column", label: "縦書き", title: "Japanese in columns, from right to left, as in books", set: { text: column, font: "Sawarabi Mincho (Japanese)", direction: "ttb", "page.finish": "lacquer", "page.world": "light", "bevel.width": 0.014, depth: 0.14 } },
    { name: "flag", label: "Flag", title: "A flag that waves: tags give it cloth and colour, the graphics card the wind", set: { text: "[mark=#1b3a8c][colour=#ffffff]\u00a0AHOY!\u00a0[/][/]", "page.motion": "flag", "bend.wave": 0.2, depth: 0.08, "bevel.width": 0.012 } },
    { name: "breathe", label: "Breathe", title: "One mesh for every weight of the font: the same triangles, while their corners move", set: { text: "breathe", "page.motion": "breathe", "page.finish": "gloss", "page.colour": "#2ec4b6", view: "wireframe", depth: 0.24, "bevel.width": 0 } },
    { name: "score", label: "1,984", title: "A score that rolls up like a mileage counter, in one mesh", set: { text: "1984", "page.motion": "score", "page.finish": "lacquer", "page.world": "dark", "page.weight": 900, "page.colour": "#ffb000", depth: 0.12, "bevel.width": 0.02 } },
    { name: "scripts", label: "Aあبअ", title: "Five scripts and emoji in one text: fonts for them are fetched when they are needed", set: { text: scripts, "page.rainbow": 1, "page.finish": "gloss", "page.world": "dark", "bevel.width": 0.02 } },
    { name: "tags", label: "[tags]", title: "Tags in the text: weight, colour, size, marks, and small text above", set: { text: "[b]Tags[/b] say [colour=#d1235b]colour[/colour],\n[size=1.6]size[/size], [mark=#ffd23f]marks[/mark]\nand [ruby=small text]ruby[/ruby] x[sup]2[/sup]", "page.colour": "#30343c", "page.weight": 650 } },
    { name: "ribbon", label: "Twist", title: "A bevelled line of text, twisted by a third of a turn, and still one closed mesh", set: { text: "Twist again", "bend.twist": 120, "page.weight": 900, "page.finish": "gold", "page.world": "light", "bevel.width": 0.026, depth: 0.25 } },
];

/** Whether two links set the same, in whatever order. */
const sorted = link => [...new URLSearchParams(link)].map(String).sort().join("&");
export const isSame = (one, other) => sorted(one) === sorted(other);

export const linkOf = preset => "#" + new URLSearchParams(preset.set);
