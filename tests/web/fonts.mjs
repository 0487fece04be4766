// SPDX-License-Identifier: MIT
// fonts.mjs FONTS_JS: which fonts the page sets a text in, with fonts that arrive when the test says so.

import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { Fonts, lettersOf } = await import(pathToFileURL(process.argv[2]));
const arriving = name => {
    const entry = { name };
    entry.asked = 0;
    const come = new Promise((arrive, fail) => Object.assign(entry, { arrive: () => arrive(name), fail: () => fail(new Error(`${name} failed`)) }));
    entry.load = () => (++entry.asked, come);
    return entry;
};
const list = names => {
    const fonts = new Fonts(bytes => `font ${bytes}`);
    const entries = Object.fromEntries(names.map(name => [name, arriving(name)]));
    for (const entry of Object.values(entries)) assert.equal(fonts.offer(entry), true);
    return { fonts, ...entries };
};

{   // Of two choices the newer one counts, whichever arrives first.
    for (const newerFirst of [true, false]) {
        const { fonts, slow, quick } = list(["slow", "quick"]);
        const old = fonts.choose(slow), now = fonts.choose(quick);
        (newerFirst ? quick : slow).arrive();
        await new Promise(setImmediate);
        (newerFirst ? slow : quick).arrive();
        assert.deepEqual([await old, await now], [false, true]);
        assert.equal(fonts.used, quick);
        assert.equal(fonts.list()[0], "font quick");
    }
}
{   // Nor does the older one's failure count; the newest one's does, and what was used stays.
    const { fonts, a, b } = list(["a", "b"]);
    a.arrive();
    assert.equal(await fonts.choose(a), true);
    const failing = fonts.choose(b), again = fonts.choose(a);
    b.fail();
    assert.deepEqual([await failing, await again], [false, true]);
    await assert.rejects(fonts.choose(b), /b failed/);
    assert.equal(fonts.used, a);
}
{   // What it lacks comes from those of the page, each fetched once; one that fails is passed over.
    const { fonts, a, b, c } = list(["a", "b", "c"]);
    fonts.offer({ name: "own", bytes: "own" });
    for (const entry of [a, c]) entry.arrive();
    b.fail();
    await fonts.choose(fonts.find("own"));
    assert.deepEqual(fonts.list(), ["font own"]);
    assert.equal(await fonts.openAnother(), true);
    assert.deepEqual(fonts.list(), ["font own", "font a"]);
    assert.equal(await fonts.openAnother(), true);
    assert.deepEqual(fonts.list(), ["font own", "font a", "font c"]);
    assert.equal(await fonts.openAnother(), false);
    assert.deepEqual([a.asked, b.asked, c.asked], [1, 1, 1]);
}
{   // The font of a text's script is fetched before all others, and comes before them, unless the chosen font has the letters.
    const fonts = new Fonts(bytes => ({ name: bytes, has: letter => letter.charCodeAt(0) < 128 || bytes === "all" }));
    const entries = ["all", "latin", "other", "greek"].map(arriving);
    Object.assign(entries[3], { letters: lettersOf(["Greek", "Emoji"]) });
    for (const entry of entries) fonts.offer(entry), entry.arrive();
    await fonts.choose(entries[0]);
    assert.equal(fonts.suit("\u03b1\u03b2"), false);
    assert.equal(fonts.awaits, false);
    await fonts.choose(entries[1]);
    assert.equal(fonts.suit("\u03b1\u03b2"), false, "it has yet to come");
    assert.equal(fonts.awaits, true);
    assert.equal(await fonts.openAnother(), true);
    assert.equal(fonts.awaits, false);
    const names = () => fonts.list().map(f => f.name);
    assert.deepEqual(names(), ["latin", "greek"], "and not the one that was chosen before");
    assert.equal(await fonts.openAnother(), true);
    assert.deepEqual(names(), ["latin", "greek", "all"]);
    assert.equal(fonts.suit("abc"), true);
    assert.deepEqual(names(), ["latin", "all", "greek"]);
    assert.equal(fonts.suit("\u{1f680}"), true);
    assert.deepEqual(names(), ["latin", "greek", "all"]);
    assert.deepEqual(entries.map(e => e.asked), [1, 1, 0, 1]);
}
{   // A choice ends the search for missing letters.
    const { fonts, a, b } = list(["a", "b"]);
    a.arrive();
    await fonts.choose(a);
    const search = fonts.openAnother(), choice = fonts.choose(a);
    b.arrive();
    assert.deepEqual([await search, await choice], [undefined, true], "and another begins");
}
{   // A font that is chosen and missed at the same time is fetched once, and asked for again after a failure.
    const { fonts, a, b } = list(["a", "b"]);
    a.arrive();
    await fonts.choose(a);
    const search = fonts.openAnother(), choice = fonts.choose(b);
    b.arrive();
    await Promise.all([search, choice]);
    assert.deepEqual([fonts.used, b.asked], [b, 1]);
    const late = { name: "late", load: () => Promise.reject(new Error("no line")) };
    fonts.offer(late);
    await assert.rejects(fonts.choose(late), /no line/);
    late.load = () => Promise.resolve("late");
    assert.equal(await fonts.choose(late), true);
}
{   // A file of the same name replaces the font.
    const fonts = new Fonts(bytes => bytes);
    assert.equal(fonts.offer({ name: "x", bytes: 1 }), true);
    assert.equal(fonts.offer({ name: "x", bytes: 2 }), false);
    await fonts.choose(fonts.find("x"));
    assert.deepEqual(fonts.list(), [2]);
    assert.equal(fonts.find("nowhere"), fonts.first);
}
{   // A weight that cannot be opened leaves the font as its file has it, and nothing that has been freed.
    let fails = false;
    const opened = (bytes, options) => {
        if (options && fails) throw new Error("no memory");
        return { bytes, weight: options?.variations.wght, axes: [{ tag: "wght", minimum: 100, default: 400, maximum: 900 }], free() { this.freed = true; } };
    };
    const fonts = new Fonts(opened);
    fonts.offer({ name: "x", bytes: 1 });
    await fonts.choose(fonts.find("x"));
    assert.equal(fonts.weigh(700), true);
    const [bold] = fonts.list();
    fails = true;
    assert.throws(() => fonts.weigh(800), /no memory/);
    assert.deepEqual([bold.weight, bold.freed, fonts.list()[0].weight, fonts.list()[0].freed], [700, true, undefined, undefined]);
    fails = false;
    assert.equal(fonts.weigh(800), true, "it is tried again");
    assert.equal(fonts.list()[0].weight, 800);
    fonts.offer({ name: "y", bytes: 2 });
    await fonts.choose(fonts.find("y"));
    assert.equal(fonts.list()[0].bytes, 2, "a font is not shown with another's weight");
}
console.log("fonts.mjs: passed");
