# SPDX-License-Identifier: MIT
#
# What font_path.hpp beside it does, for scripts, which source this after setting font_names to the path of that header.

# Where a font such as truetype/dejavu/DejaVuSans.ttf lies, by its name of Debian 12 or by the one that it has now.
font_file() {  # font_file NAME
    font_folder=${TYPEMESH_FONT_DIR:-/usr/share/fonts}
    font_now=$(sed -nE "s,^ *[{]\"$1\"\, \"(.*)\"[}]\,\$,\\1,p" "${font_names:?}")
    if [ ! -e "$font_folder/$1" ] && [ -n "$font_now" ] && [ -e "$font_folder/$font_now" ]; then
        printf '%s\n' "$font_folder/$font_now"
    else
        printf '%s\n' "$font_folder/$1"
    fi
}
