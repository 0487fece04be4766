#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'END'
usage: examples/run.sh [TEXT...] [option of text_to_mesh...]

This script installs what is missing, builds text_to_mesh, chooses an installed font with the letters of TEXT
("Hello world!") and writes hello.glb and hello.png in the current directory. Words without quotes become one text.
Write options after the text, and text_to_mesh gets them: examples/run.sh "Hello" --depth 0.3
examples/run.sh "Hello" --help lists all of them.
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

# The scripts of the world: name, first and last code point, Debian packages that have a font of it, and its font
# families, the best of each first. Where nothing is said: fonts-noto-core, and Noto Sans NAME or Noto Serif NAME.
# The first line that a text has a letter of chooses its font: kana before Han tell Japanese from Chinese. A line with +
# counts only where the text has letters of that script already.
scripts() {
    cat <<'END'
Armenian|530|58f|fonts-dejavu-core|DejaVu Sans,Noto Sans Armenian
Hebrew|590|5ff|culmus|Frank Ruehl CLM,Noto Sans Hebrew
Hebrew|fb1d|fb4f|culmus|Frank Ruehl CLM,Noto Sans Hebrew
Syriac|700|74f||
Thaana|780|7bf||
N'Ko|7c0|7ff||Noto Sans NKo
Arabic|600|8ff|fonts-hosny-amiri|Amiri,Noto Naskh Arabic,Noto Sans Arabic
Arabic|fb50|fdff|fonts-hosny-amiri|Amiri,Noto Naskh Arabic,Noto Sans Arabic
Arabic|fe70|fefe|fonts-hosny-amiri|Amiri,Noto Naskh Arabic,Noto Sans Arabic
Devanagari|900|97f|fonts-lohit-deva|Lohit Devanagari,Noto Sans Devanagari
Bengali|980|9ff|fonts-lohit-beng-bengali|Lohit Bengali,Noto Sans Bengali
Gurmukhi|a00|a7f|fonts-lohit-guru|Lohit Gurmukhi,Noto Sans Gurmukhi
Gujarati|a80|aff|fonts-lohit-gujr|Lohit Gujarati,Noto Sans Gujarati
Odia|b00|b7f|fonts-lohit-orya|Lohit Odia,Noto Sans Oriya
Tamil|b80|bff|fonts-lohit-taml|Lohit Tamil,Noto Sans Tamil
Telugu|c00|c7f|fonts-lohit-telu|Lohit Telugu,Noto Sans Telugu
Kannada|c80|cff|fonts-lohit-knda|Lohit Kannada,Noto Sans Kannada
Malayalam|d00|d7f|fonts-lohit-mlym|Lohit Malayalam,Noto Sans Malayalam
Sinhala|d80|dff||
Thai|e00|e7f|fonts-tlwg-garuda-ttf|Garuda,Purisa,Noto Sans Thai
Lao|e80|eff||
Tibetan|f00|fff||
Myanmar|1000|109f||
Georgian|10a0|10ff|fonts-dejavu-core|DejaVu Sans,Noto Sans Georgian
Georgian|1c90|1cbf||
Ethiopic|1200|139f||
Ethiopic|2d80|2ddf||
Ethiopic|ab00|ab2f||
Cherokee|13a0|13ff||
Cherokee|ab70|abbf||
Canadian syllabics|1400|167f|fonts-dejavu-core|DejaVu Sans,Noto Sans Canadian Aboriginal
Ogham|1680|169f|fonts-dejavu-core|DejaVu Sans,Noto Sans Ogham
Runic|16a0|16ff||
Khmer|1780|17ff||
Khmer|19e0|19ff||
Mongolian|1800|18af||
Balinese|1b00|1b7f||
Glagolitic|2c00|2c5f||
Coptic|2c80|2cff||
Tifinagh|2d30|2d7f|fonts-dejavu-core|DejaVu Sans,Noto Sans Tifinagh
Yi|a000|a4cf||
Javanese|a980|a9df||
Korean|1100|11ff|fonts-nanum,fonts-noto-cjk|NanumGothic,Noto Sans CJK KR
Korean|3130|318f|fonts-nanum,fonts-noto-cjk|NanumGothic,Noto Sans CJK KR
Korean|ac00|d7ff|fonts-nanum,fonts-noto-cjk|NanumGothic,Noto Sans CJK KR
+Korean|2e80|ffef|fonts-noto-cjk|Noto Sans CJK KR
Japanese|3040|30ff|fonts-sawarabi-mincho,fonts-noto-cjk|Sawarabi Mincho,Sawarabi Gothic,Noto Serif CJK JP,Noto Sans CJK JP
+Japanese|2e80|ffef|fonts-sawarabi-mincho,fonts-noto-cjk|Sawarabi Mincho,Sawarabi Gothic,Noto Serif CJK JP,Noto Sans CJK JP
Chinese|2e80|9fff|fonts-wqy-microhei,fonts-noto-cjk,fonts-hanazono|WenQuanYi Micro Hei,Noto Sans CJK SC,Noto Serif CJK SC
Chinese|f900|faff|fonts-noto-cjk,fonts-hanazono|Noto Sans CJK SC,Noto Serif CJK SC
Chinese|ff00|ffef|fonts-wqy-microhei,fonts-noto-cjk|WenQuanYi Micro Hei,Noto Sans CJK SC
Chinese|20000|3ffff|fonts-noto-cjk,fonts-hanazono|Noto Sans CJK SC,Noto Serif CJK SC
Cuneiform|12000|1254f||
hieroglyphs|13000|1345f||Noto Sans Egyptian Hieroglyphs
symbols|2190|2bff|fonts-symbola|DejaVu Sans,Symbola,Noto Sans Symbols
symbols|1d100|1d7ff|fonts-symbola|Symbola,Noto Music,Noto Sans Math
symbols|1f000|1faff|fonts-symbola|Symbola,Noto Emoji
digits and punctuation|20|40|fonts-dejavu-core|Liberation Sans,DejaVu Sans,Noto Sans,Arial,Helvetica
Latin, Greek or Cyrillic|0|52f|fonts-dejavu-core|Liberation Sans,DejaVu Sans,Noto Sans,Arial,Helvetica
Latin, Greek or Cyrillic|1d00|1fff|fonts-dejavu-core|DejaVu Sans,Noto Sans,Arial
other|0|10ffff||DejaVu Sans,Noto Sans
END
}

# The scripts of a text, one line each in the order above: name, packages, families, and its own code points.
scripts_of() {  # scripts_of CODE_POINT...
    local left=" $* " name first last packages families code found seen=
    while IFS='|' read -r name first last packages families; do
        case $name in
            +*)
                name=${name#+}
                case $seen in *"|$name|"*) ;; *) continue ;; esac
                ;;
        esac
        found=
        for code in $left; do
            if [ $((16#$code)) -ge $((16#$first)) ] && [ $((16#$code)) -le $((16#$last)) ]; then
                found="$found $code"
                left=${left/ $code / }
            fi
        done
        if [ -n "$found" ]; then
            seen="$seen|$name|"
            say "$name|${packages:-fonts-noto-core}|${families:-Noto Sans $name,Noto Serif $name}|${found# }"
        fi
    done < <(scripts) | awk -F '|' '
        $1 in codes { packages[$1] = packages[$1] "," $2; codes[$1] = codes[$1] " " $4; next }
        { name[++n] = $1; packages[$1] = $2; families[$1] = $3; codes[$1] = $4 }
        END { for (i = 1; i <= n; ++i) print name[i] "|" packages[name[i]] "|" families[name[i]] "|" codes[name[i]] }'
}

# The best installed outline font that has every code point: file, face and family, separated by tabs. Empty without one.
font_with() {  # font_with FAMILIES CODE_POINT...
    local families=$1
    shift
    fc-list ":charset=$*:scalable=true:color=false" \
        --format '%{file}\t%{index}\t%{family[0]}\t%{fontformat}\t%{weight}\t%{slant}\t%{variable}\t%{width}\n' |
        awk -F '\t' -v families="$families" '
            BEGIN { n = split(families, name, ",") }
            !/\.(ttf|otf|ttc|otc)\t/ || ($4 != "TrueType" && $4 != "CFF") { next }
            $7 != "True" && $2 >= 65536 { next }  # a named instance of a variable font
            {
                score = 10 * n + 10
                for (i = 1; i <= n; ++i) if ($3 == name[i]) score = 10 * i
                if ($7 != "True" && $5 != 80) score += $5 > 70 && $5 <= 100 ? 1 : 2  # book and medium before bold and light
                if ($7 != "True" && $8 != 100) score += 3                            # condensed
                if ($6 != 0) score += 4                                              # slanted
                print score "\t" $1 "\t" ($2 < 0 || $2 >= 65536 ? 0 : $2) "\t" $3
            }' | sort -t "$(printf '\t')" -k 1,1n -k 2,2 | head -n 1 | cut -f 2-
}

# The code points that no installed font has; after eight dots stand for the rest.
without_font() {  # without_font CODE_POINT...
    local code found=0
    for code in "$@"; do
        [ -z "$(font_with "" "$code")" ] || continue
        found=$((found + 1))
        [ $found -le 8 ] || { printf ' ...' && break; }
        printf ' U+%04X' $((16#$code))
    done
}

# The code points that no font can have: Unicode keeps the last two of each plane and U+FDD0 to U+FDEF for no character.
noncharacters() {  # noncharacters CODE_POINT...
    local code
    for code in "$@"; do
        if [ $((16#$code & 65534)) = 65534 ] || { [ $((16#$code)) -ge 64976 ] && [ $((16#$code)) -le 65007 ]; }; then
            printf ' %s' "$code"
        fi
    done
}

# Where no installed font has all the letters: which are missing, and the first package of their script that is not there.
explain_missing_font() {  # explain_missing_font CODE_POINT...
    local script packages families codes code font missing package covered='' advice='' exhausted='' undrawn='' rest=" $* "
    codes=$(noncharacters "$@")
    if [ -n "$codes" ]; then
        for code in $codes; do rest=${rest/ $code / }; done
        # shellcheck disable=SC2046,SC2086  # lists of words
        say "$(printf 'U+%s ' $(printf '%04X ' $(printf '0x%s ' $codes)))is not a character, and no font has it: leave it out."
        # shellcheck disable=SC2086
        [ -n "${rest// /}" ] && [ -z "$(font_with "" $rest)" ] || return 0
        # shellcheck disable=SC2086
        set -- $rest
    fi
    say "No installed font has all the letters of this text."
    while IFS='|' read -r script packages families codes; do
        # shellcheck disable=SC2086  # a list of words
        font=$(font_with "$families" $codes | cut -f 3)
        if [ -n "$font" ]; then
            covered="$covered; $script in $font"
            continue
        fi
        # shellcheck disable=SC2086
        missing=$(without_font $codes)
        if [ -n "$missing" ]; then
            say "No font has these: $script,$missing"
            undrawn=1
        else
            say "Several fonts together have these: $script"
        fi
        for package in $(say "$packages,fonts-noto-core,fonts-unifont" | tr , ' '); do
            if ! is_installed "$package"; then
                case " $advice " in *" $package "*) ;; *) advice="$advice $package" ;; esac
                continue 2
            fi
        done
        exhausted="$exhausted, $script"
    done <<END
$(scripts_of "$@")
END
    [ -z "$exhausted" ] || say "The Debian packages of this script's list are already installed: ${exhausted#, }."
    if [ -n "$advice" ]; then
        say "On Debian, run: sudo apt-get install$advice"
    elif [ -n "$covered" ] && [ -z "$undrawn" ]; then
        say "Make several texts of it: ${covered#; }."
    fi
    say "Or give a font: examples/run.sh TEXT --font FILE"
}

case ${1:-} in -h | --help) usage && exit 0 ;; esac
text=
given=0
while [ $# -gt 0 ]; do
    case $1 in
        --)  # the next is text, whatever it begins with
            shift
            [ $# -gt 0 ] || break
            ;;
        --* | -h) break ;;
    esac
    [ $given = 0 ] || text="$text "
    text=$text$1
    given=$((given + 1))
    shift
done
[ $given != 0 ] || text="Hello world!"
[ $given -le 1 ] || say "The text is \"$text\": put it in quotes to keep its spaces."
font=
output=hello.glb
picture=hello.png
value_of=  # the option that the next word belongs to
for option in "$@"; do
    case $value_of in
        "") ;;
        *)
            case $value_of in --output) output=$option ;; --picture) picture=$option ;; esac
            value_of=
            continue
            ;;
    esac
    case $option in
        --merge | --no-merge | --instances | --strict | --stats | --version) ;;  # without a value
        -h | --help) output= && picture= && break ;;                             # nothing will be written
        --output=*) output=${option#*=} ;;
        --picture=*) picture=${option#*=} ;;
        --font=*) font=given ;;
        --*=*) ;;
        --) stop "The text stands before all options: examples/run.sh \"Hello\" --depth 0.3" ;;
        --*)
            value_of=$option
            [ "$option" != --font ] || font=given
            ;;
        *) stop "The text stands before all options: examples/run.sh \"Hello\" --depth 0.3" ;;
    esac
done

program=$typemesh_root/build/release/examples/text_to_mesh
# True where the program is there and no source is newer.
is_built() {
    [ -x "$program" ] && (
        cd "$typemesh_root"
        [ -z "$(find examples include cmake CMakeLists.txt CMakePresets.json -type f -newer "$program" 2>/dev/null)" ]
    )
}

if is_built; then  # the picture is then there at once
    install_missing fontconfig font
    to_build=
elif (need_build_folder release) >/dev/null 2>&1; then
    install_missing c++ cmake ninja pkg-config harfbuzz freetype cli11 tinygltf stb fontconfig font
    to_build=1
else
    need_build_folder release
fi

if [ -z "$font" ]; then
    read -r -a codes <<<"$(code_points "$text")" || true
    IFS='|' read -r _ _ families _ <<<"$(scripts_of ${codes[@]+"${codes[@]}"} 30)"
    IFS=$'\t' read -r font face family <<<"$(font_with "$families" ${codes[@]+"${codes[@]}"})"
    [ -n "$font" ] || stop "$(explain_missing_font ${codes[@]+"${codes[@]}"})"
    say "The font is $family ($font)"
    set -- --font "$font" --face "$face" "$@"
fi

if [ -n "$to_build" ]; then
    [ -e "$program" ] || say "This builds text_to_mesh once, usually in one to three minutes."
    build_preset release text_to_mesh || exit 1
    touch "$program"  # it is newer than sources of other programs, too
fi
# Written unless named by the caller already.
for option in "$@"; do
    case $option in
        --output | --output=*) own_output=1 ;;
        --picture | --picture=*) own_picture=1 ;;
    esac
done
[ -n "${own_output:-}" ] || [ -z "$output" ] || set -- --output "$output" "$@"
[ -n "${own_picture:-}" ] || [ -z "$picture" ] || set -- --picture "$picture" "$@"
"$program" "$@" -- "$text" || exit $?
for file in "$output" "$picture"; do
    case $file in
        "") ;;
        /*) say "text_to_mesh has written $file" ;;
        *) say "text_to_mesh has written $PWD/$file" ;;
    esac
done
