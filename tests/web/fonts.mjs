// SPDX-License-Identifier: MIT
// fonts.mjs FONTS_JS: which fonts the page sets a text in, with fonts that arrive when the test says so.

import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";

const { Fonts } = await import(pathToFileURL(process.argv[2]));
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
{   // A choice ends the search for missing letters.
    const { fonts, a, b } = list(["a", "b"]);
    a.arrive();
    await fonts.choose(a);
    const search = fonts.openAnother(), choice = fonts.choose(a);
    b.arrive();
    assert.deepEqual([await search, await choice], [false, true]);
}
{   // A file of the same name replaces the font.
    const fonts = new Fonts(bytes => bytes);
    assert.equal(fonts.offer({ name: "x", bytes: 1 }), true);
    assert.equal(fonts.offer({ name: "x", bytes: 2 }), false);
    await fonts.choose(fonts.find("x"));
    assert.deepEqual(fonts.list(), [2]);
    assert.equal(fonts.find("nowhere"), fonts.first);
}
console.log("fonts.mjs: passed");
