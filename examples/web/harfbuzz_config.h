/* SPDX-License-Identifier: MIT */

/* HarfBuzz without what no mesh of a text needs: Apple's layout tables, mathematics, colours and bitmaps, files, threads,
   text forms of its buffers. All scripts are shaped, all outlines drawn, as by a HarfBuzz with everything. */
#define HB_DISABLE_DEPRECATED
#define HB_NO_AAT
#define HB_NO_BITMAP
#define HB_NO_BUFFER_MESSAGE
#define HB_NO_BUFFER_SERIALIZE
#define HB_NO_BUFFER_VERIFY
#define HB_NO_COLOR
#define HB_NO_ERRNO
#define HB_NO_FACE_COLLECT_UNICODES
#define HB_NO_FALLBACK_SHAPE
#define HB_NO_GETENV
#define HB_NO_HINTING
#define HB_NO_LAYOUT_COLLECT_GLYPHS
#define HB_NO_LAYOUT_FEATURE_PARAMS
#define HB_NO_MATH
#define HB_NO_META
#define HB_NO_MMAP
#define HB_NO_MT
#define HB_NO_OPEN
#define HB_NO_OT_FONT_GLYPH_NAMES
#define HB_NO_SETLOCALE
#define HB_NO_STYLE
