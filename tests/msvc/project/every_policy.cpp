// SPDX-License-Identifier: MIT
//
// All headers after Windows' own with all their macros, min, max, near, far and small among them, and the templates made
// of them. Nothing is run.
#define STRICT
#include <winsock2.h>

#include <windows.h>

#include <d3d11.h>
#include <d3d9.h>
#include <objbase.h>

#include <compile/strict_warnings.cpp>

error every_solid(directwrite_font& font);
error every_solid(directwrite_font& font)
{
    test::toy_font toy;
    if (error e = everything(text_mesher{toy}.with(bevelled{.profile = round_profile()}).with(constrained_delaunay{})))
        return e;
    if (error e = everything(text_mesher{toy}.with(embolden{}))) return e;
    if (error e = everything(text_mesher{toy}.with(outlined<>{}))) return e;
    return everything(text_mesher{font}.with(bevelled{}));
}
