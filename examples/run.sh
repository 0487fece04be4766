#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'END'
usage: examples/run.sh [TEXT] [option of text_to_mesh...]

Installs what is missing, builds text_to_mesh, picks an installed font with the letters of TEXT ("Hello world!") and
writes hello.glb and hello.png in the current directory. An option is passed on: examples/run.sh "Hello" --depth 0.3
examples/run.sh "Hello" --help names them all.
END
}

# The code points of a UTF-8 text in hexadecimal, each once, blanks and invisible ones left out.
code_points() {  # code_points TEXT
    printf '%s' "$1" | od -An -v -tu1 | awk '
        function ends() {
            if (left != 0 || code <= 32 || seen[code]++) return
            if (code == 160 || code == 173 || code == 12288) return
            if ((code >= 8192 && code <= 8207) || (code >= 8232 && code <= 8239) || (code >= 8288 && code <= 8303)) return
            if ((code >= 65024 && code <= 65039) || code == 65279) return
            printf "%x ", code
        }
        {
            for (i = 1; i <= NF; ++i) {
                if ($i < 128) { left = 0; code = $i }
                else if ($i < 192) { if (left == 0) continue; --left; code = code * 64 + $i - 128 }
                else if ($i < 224) { left = 1; code = $i - 192 }
                else if ($i < 240) { left = 2; code = $i - 224 }
                else { left = 3; code = $i - 240 }
                ends()
            }
        }'
}

# One line for the script of a text: its name, the Debian package of a font for it, and font families in order of
# preference. The first script of the table that the text has decides: kana before Han tells Japanese from Chinese.
script_of() {  # script_of CODE_POINT...
    local name first last package families code
    while IFS='|' read -r name first last package families; do
        for code in "$@"; do
            if [ $((16#$code)) -ge $((16#$first)) ] && [ $((16#$code)) -le $((16#$last)) ]; then
                say "$name|$package|$families"
                return
            fi
        done
    done <<'END'
Arabic|600|8ff|fonts-hosny-amiri|Amiri,Noto Naskh Arabic,Noto Sans Arabic
Arabic|fb50|feff|fonts-hosny-amiri|Amiri,Noto Naskh Arabic,Noto Sans Arabic
Hebrew|590|5ff|culmus|Frank Ruehl CLM,Noto Sans Hebrew
Devanagari|900|97f|fonts-lohit-deva|Lohit Devanagari,Noto Sans Devanagari
Bengali|980|9ff|fonts-lohit-beng-bengali|Lohit Bengali,Noto Sans Bengali
Gurmukhi|a00|a7f|fonts-lohit-guru|Lohit Gurmukhi,Noto Sans Gurmukhi
Gujarati|a80|aff|fonts-lohit-gujr|Lohit Gujarati,Noto Sans Gujarati
Odia|b00|b7f|fonts-lohit-orya|Lohit Odia,Noto Sans Oriya
Tamil|b80|bff|fonts-lohit-taml|Lohit Tamil,Noto Sans Tamil
Telugu|c00|c7f|fonts-lohit-telu|Lohit Telugu,Noto Sans Telugu
Kannada|c80|cff|fonts-lohit-knda|Lohit Kannada,Noto Sans Kannada
Malayalam|d00|d7f|fonts-lohit-mlym|Lohit Malayalam,Noto Sans Malayalam
Thai|e00|e7f|fonts-tlwg-garuda-ttf|Garuda,Purisa,Noto Sans Thai
Korean|ac00|d7af|fonts-nanum|NanumGothic,Noto Sans CJK KR
Japanese|3040|30ff|fonts-sawarabi-mincho|Sawarabi Mincho,Sawarabi Gothic,Noto Serif CJK JP,Noto Sans CJK JP
Chinese|2e80|9fff|fonts-wqy-microhei|WenQuanYi Micro Hei,Noto Sans CJK SC,Noto Serif CJK SC
Chinese|20000|3ffff|fonts-noto-cjk|Noto Sans CJK SC,Noto Serif CJK SC
symbol|2190|2bff|fonts-symbola|DejaVu Sans,Symbola,Noto Sans Symbols
symbol|1f000|1faff|fonts-symbola|Symbola,Noto Emoji
Latin, Greek or Cyrillic|0|52f|fonts-dejavu-core|Liberation Sans,DejaVu Sans,Noto Sans,Arial,Helvetica
other|0|10ffff|fonts-noto-core|DejaVu Sans,Noto Sans
END
}

# The best installed outline font that has every code point: file, face and family, separated by tabs. Empty without one.
font_with() {  # font_with FAMILIES CODE_POINT...
    local families=$1
    shift
    fc-list ":charset=$*:scalable=true:color=false" \
        --format '%{file}\t%{index}\t%{family[0]}\t%{fontformat}\t%{weight}\t%{slant}\t%{variable}\n' |
        awk -F '\t' -v families="$families" '
            BEGIN { n = split(families, name, ",") }
            !/\.(ttf|otf|ttc|otc)\t/ || ($4 != "TrueType" && $4 != "CFF") { next }
            $7 != "True" && $2 >= 65536 { next }  # a named instance of a variable font
            {
                score = 10 * n + 10
                for (i = 1; i <= n; ++i) if ($3 == name[i]) score = 10 * i
                if ($7 != "True" && $5 != 80) score += $5 > 70 && $5 <= 100 ? 1 : 2  # book and medium before bold and light
                if ($6 != 0) score += 4                                              # slanted
                print score "\t" $1 "\t" ($2 < 0 || $2 >= 65536 ? 0 : $2) "\t" $3
            }' | sort -t "$(printf '\t')" -k 1,1n -k 2,2 | head -n 1 | cut -f 2-
}

text="Hello world!"
case ${1:-} in
    -h | --help) usage && exit 0 ;;
    --) shift && if [ $# -gt 0 ]; then text=$1 && shift; fi ;;
    --*) ;;
    *) if [ $# -gt 0 ]; then text=$1 && shift; fi ;;
esac
font=
output="--output hello.glb"
picture="--picture hello.png"
for option in "$@"; do
    case $option in
        --font | --font=*) font=given ;;
        --output | --output=*) output= ;;
        --picture | --picture=*) picture= ;;
        -h | --help) output= && picture= ;;  # nothing will be written
    esac
done

install_missing c++ cmake ninja pkg-config harfbuzz freetype cli11 tinygltf stb fontconfig font

if [ -z "$font" ]; then
    read -r -a codes <<<"$(code_points "$text")" || true
    IFS='|' read -r script package families <<<"$(script_of ${codes[@]+"${codes[@]}"} 48)"
    IFS=$'\t' read -r font face family <<<"$(font_with "$families" ${codes[@]+"${codes[@]}"})"
    if [ -z "$font" ]; then
        stop "No installed font has all the letters of this text (script: $script)." \
            "On Debian: sudo apt-get install $package" "Or name a font: examples/run.sh TEXT --font FILE"
    fi
    say "Font: $family ($font)"
    set -- --font "$font" --face "$face" "$@"
fi

[ -e "$typemesh_root/build/release/examples/text_to_mesh" ] || say "Building text_to_mesh; this is done once."
build_preset release text_to_mesh || exit 1
# shellcheck disable=SC2086  # two words or none
"$typemesh_root/build/release/examples/text_to_mesh" $output $picture "$@" -- "$text"
for file in ${output#--output} ${picture#--picture}; do
    say "Wrote $PWD/$file"
done
