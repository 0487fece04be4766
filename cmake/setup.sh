# SPDX-License-Identifier: MIT
#
# What examples/run.sh and tests/run.sh share: finding out what is missing, installing it, building a preset. Sourced by
# bash (3.2 or newer) after `set -eu`; typemesh_root is the folder of CMakeLists.txt.

# One line a need: how to see that it is there, and its package in each place. "-" where there is none or none is needed.
#   command:A,B  one of these programs      header:A,B  one of these headers      font:A  a font with this character
#   pkg:A,B      one that pkg-config knows                     clang++:A   clang++ links a program with this option
#   python:A     a module of python3
# Every run of the tests tests Debian's column. The other four are untested: their names come from the lists
# of those systems.
needs() {
    cat <<'END'
# need       is there when                                    Debian             Fedora, untried        Arch, untried Homebrew, untried vcpkg, untried
g++          command:g++                                      g++                gcc-c++                gcc         gcc               -
c++          command:c++,g++,clang++                          g++                gcc-c++                gcc         llvm              -
clang++      command:clang++                                  clang              clang                  clang       llvm              -
asan         clang++:-fsanitize=address                       libclang-rt-dev    compiler-rt            compiler-rt llvm              -
cmake        command:cmake                                    cmake              cmake                  cmake       cmake             -
ninja        command:ninja,make                               ninja-build        ninja-build            ninja       ninja             -
pkg-config   command:pkg-config                               pkg-config         pkgconf-pkg-config     pkgconf     pkgconf           -
fontconfig   command:fc-list                                  fontconfig         fontconfig             fontconfig  fontconfig        -
font         font:48                                          fonts-dejavu-core  dejavu-sans-fonts      ttf-dejavu  -                 -
harfbuzz     header:harfbuzz/hb.h                             libharfbuzz-dev    harfbuzz-devel         harfbuzz    harfbuzz          harfbuzz
freetype     header:freetype2/ft2build.h,ft2build.h           libfreetype-dev    freetype-devel         freetype2   freetype          freetype
icu          header:unicode/ubrk.h                            libicu-dev         libicu-devel           icu         icu4c             icu
glm          header:glm/vec3.hpp                              libglm-dev         glm-devel              glm         glm               glm
mingw        command:x86_64-w64-mingw32-g++-posix,x86_64-w64-mingw32-g++ g++-mingw-w64-x86-64-posix mingw64-gcc-c++ mingw-w64-gcc mingw-w64 -
wine         command:wine                                     wine               wine                   wine        wine-stable       -
xvfb         command:Xvfb                                     xvfb               xorg-x11-server-Xvfb   xorg-server-xvfb -           -
catch2       header:catch2/catch_all.hpp,catch2/catch.hpp     catch2             catch-devel            catch2      catch2            catch2
benchmark    header:benchmark/benchmark.h                     libbenchmark-dev   google-benchmark-devel benchmark   google-benchmark  benchmark
cli11        header:CLI/CLI.hpp                               libcli11-dev       cli11-devel            cli11       cli11             cli11
tinygltf     header:tiny_gltf.h,tinygltf/tiny_gltf.h          libtinygltf-dev    tinygltf-devel         tinygltf    vcpkg:tinygltf    tinygltf
stb          header:stb/stb_image_write.h,stb_image_write.h   libstb-dev         stb_image_write-devel  stb         vcpkg:stb         stb
fontconfig-dev header:fontconfig/fontconfig.h                 libfontconfig-dev  fontconfig-devel       fontconfig  fontconfig        fontconfig
lib3mf       header:lib3mf/Model/COM/NMR_DLLInterfaces.h      lib3mf-dev         -                      -           -                 -
pugixml      header:pugixml.hpp                               libpugixml-dev     pugixml-devel          pugixml     pugixml           pugixml
admesh       command:admesh                                   admesh             admesh                 admesh      admesh            -
openscad     command:openscad                                 openscad           openscad               openscad    openscad          -
python3      command:python3                                  python3            python3                python      python            -
certificates command:update-ca-certificates,update-ca-trust,trust,security ca-certificates ca-certificates ca-certificates -    -
matplotlib   python:matplotlib                                python3-matplotlib python3-matplotlib     python-matplotlib python-matplotlib -
valgrind     command:valgrind                                 valgrind           valgrind               valgrind    -                 -
clang-format command:clang-format-19                          clang-format-19    -                      -           -                 -
node         command:node                                     nodejs             nodejs                 nodejs      node              -
npm          command:npm                                      npm                nodejs-npm             npm         node              -
chromium     command:chromium,chromium-browser,google-chrome  chromium           chromium               chromium    -                 -
godot3       command:godot3-server                            godot3-server      -                      -           -                 -
opengl       pkg:gl                                           libgl-dev          mesa-libGL-devel       mesa        -                 -
openscenegraph pkg:openscenegraph                             libopenscenegraph-dev OpenSceneGraph-devel openscenegraph open-scene-graph -
irrlicht     header:irrlicht/irrlicht.h                       libirrlicht-dev    irrlicht-devel         irrlicht    irrlicht          -
ogre         pkg:OGRE                                         libogre-1.12-dev   ogre-devel             -           -                 -
qt-quick3d   pkg:Qt6Quick3D                                   qt6-quick3d-dev    qt6-qtquick3d-devel    qt6-quick3d qt                -
qt-qml       pkg:Qt6Quick                                     qt6-declarative-dev qt6-qtdeclarative-devel qt6-declarative -           -
qt-shaders   pkg:Qt6ShaderTools                               qt6-shadertools-dev qt6-qtshadertools-devel qt6-shadertools -           -
ftgl         pkg:ftgl                                         libftgl-dev        ftgl-devel             ftgl        -                 -
glu          pkg:glu                                          libglu1-mesa-dev   mesa-libGLU-devel      glu         -                 -
qt3d         pkg:Qt53DExtras                                  qt3d5-dev          qt5-qt3d-devel         qt5-3d      -                 -
vtk          header:vtk-9.1/vtkVectorText.h,vtk-9.2/vtkVectorText.h,vtk-9.3/vtkVectorText.h,vtk-9.5/vtkVectorText.h libvtk9-dev vtk-devel vtk - -
coin         header:Inventor/nodes/SoText3.h                  libcoin-dev        Coin4-devel            coin        -                 -
occt         header:opencascade/StdPrs_BRepFont.hxx           libocct-visualization-dev opencascade-devel opencascade -               -
occt-modeling header:opencascade/BRepMesh_IncrementalMesh.hxx libocct-modeling-algorithms-dev opencascade-devel opencascade -         -
blender      command:blender                                  blender            blender                blender     -                 -
cgal         header:CGAL/Constrained_Delaunay_triangulation_2.h libcgal-dev      CGAL-devel             cgal        -                 -
polyclipping header:polyclipping/clipper.hpp                  libpolyclipping-dev polyclipping-devel    -           -                 -
debootstrap  command:debootstrap                              debootstrap        debootstrap            debootstrap -                 -
dpkg-shlibdeps command:dpkg-shlibdeps                         dpkg-dev           dpkg-dev               dpkg        dpkg              -
doxygen      command:doxygen                                  doxygen            doxygen                doxygen     doxygen           -
esbuild      command:esbuild                                  esbuild            -                      esbuild     esbuild           -
brotli       command:brotli                                   brotli             brotli                 brotli      brotli            -
emcc         command:em++                                     emscripten         emscripten             emscripten  emscripten        -
libc++       clang++:-stdlib=libc++                          libc++-dev         libcxx-devel           libc++      llvm              -
i686         command:i686-linux-gnu-g++                      g++-i686-linux-gnu -                      -           -                 -
aarch64      command:aarch64-linux-gnu-g++                   g++-aarch64-linux-gnu -                   -           -                 -
armhf        command:arm-linux-gnueabihf-g++                 g++-arm-linux-gnueabihf -                 -           -                 -
riscv64      command:riscv64-linux-gnu-g++                   g++-riscv64-linux-gnu -                   -           -                 -
s390x        command:s390x-linux-gnu-g++                     g++-s390x-linux-gnu -                     -           -                 -
qemu         command:qemu-s390x                              qemu-user          qemu-user              qemu-user   qemu              -
dpkg-source  command:dpkg-source                              dpkg-dev           -                      -           -                 -
imagemagick  command:mogrify                                  imagemagick        ImageMagick            imagemagick imagemagick       -
pngquant     command:pngquant                                 pngquant           pngquant               pngquant    pngquant          -
glslang      command:glslangValidator                         glslang-tools      glslang                glslang     glslang           -
spirv-cross  command:spirv-cross                              spirv-cross        -                      spirv-cross spirv-cross       -
pyflakes     command:pyflakes3                                pyflakes3          python3-pyflakes       python-pyflakes -             -
END
}

: "${typemesh_root:?}"

say() { printf '%s\n' "$*"; }
stop() {
    printf '%s\n' "$@" >&2
    exit 1
}

# Whether a need is there, by the second column of the table.
is_there() {  # is_there KIND:NAME,NAME...
    local name folder
    for name in $(say "${1#*:}" | tr , ' '); do
        case $1 in
            command:*) ! command -v "$name" >/dev/null 2>&1 || return 0 ;;
            header:*)
                while IFS= read -r folder; do
                    [ ! -e "$folder/$name" ] || return 0
                done <<END
$(header_folders)
END
                ;;
            clang++:*) ! say 'int main() {}' | clang++ "$name" -x c++ - -o /dev/null 2>/dev/null || return 0 ;;
            python:*) ! "$(python_with "$name")" -c "import $name" 2>/dev/null || return 0 ;;
            pkg:*) ! pkg-config --exists "$name" 2>/dev/null || return 0 ;;
            font:*) ! command -v fc-list >/dev/null 2>&1 || [ -z "$(fc-list ":charset=$name" file)" ] || return 0 ;;
        esac
    done
    return 1
}

# The python3 that has a module; the system's own may not be the first of the path.
python_with() {  # python_with MODULE
    if ! python3 -c "import $1" 2>/dev/null && [ -x /usr/bin/python3 ]; then say /usr/bin/python3; else say python3; fi
}

header_folders() {
    say /usr/include
    say /usr/local/include
    say "${HOMEBREW_PREFIX:-/opt/homebrew}/include"
    say "${CMAKE_PREFIX_PATH:-}" | tr ':;' '\n' | sed '/./s,$,/include,'
    [ -z "${VCPKG_ROOT:-}" ] || printf '%s\n' "$VCPKG_ROOT"/installed/*/include
}

# The packages of what is missing among the needs named, in one column of the table.
column_of_missing() {  # column_of_missing COLUMN NEED...   columns: 3 Debian, 4 Fedora, 5 Arch, 6 Homebrew, 7 vcpkg
    local column=$1 need there rest
    shift
    needs | while read -r need there rest; do
        case " $* " in
            *" $need "*) is_there "$there" || say "$need $there $rest" | awk -v c="$column" '$c != "-" { print $c }' ;;
        esac
    done | awk '!seen[$0]++ { printf "%s%s", n++ ? " " : "", $0 }'
}

# Runs a command, whose words go to a log, and tells meanwhile how long it has taken and how far it is: on a terminal in one
# line that is written anew every second, elsewhere in a new line every 30 s (or TYPEMESH_PROGRESS_SECONDS).
with_progress() {  # with_progress LOG COMMAND...
    local log=$1 teller status=0
    shift
    tell_progress "$log" &
    teller=$!
    "$@" || status=$?
    kill "$teller" 2>/dev/null || true
    wait "$teller" 2>/dev/null || true
    [ ! -t 1 ] || printf '\033[K'
    return $status
}

logged() {  # logged LOG COMMAND...
    local log=$1
    shift
    "$@" >>"$log" 2>&1
}

tell_progress() {  # tell_progress LOG; ends soon after the script that started it
    local every=${TYPEMESH_PROGRESS_SECONDS:-30} end='\n' seconds=0
    if [ -t 1 ]; then every=1 end='\033[K\r'; fi
    while sleep 1 >/dev/null 2>&1 && kill -0 $$ 2>/dev/null; do
        seconds=$((seconds + 1))
        [ $((seconds % every)) != 0 ] ||
            printf '  %d:%02d  %s%b' $((seconds / 60)) $((seconds % 60)) "$(progress_of "$1")" "$end"
    done
}

# How far the program is that writes a log: ninja, make and ctest count, of others the last line tells most. Tests that
# have failed so far are counted too.
progress_of() {  # progress_of LOG
    awk '
        /^ *[0-9]+\/[0-9]+ Test +#.*\*\*\*/ && !/\*\*\*Skipped/ { ++failed }
        !tests && match($0, /^\[ *[0-9]+%\]/) { told = substr($0, 2, RLENGTH - 2); next }
        !tests && match($0, /^\[[0-9]+\/[0-9]+\]/) { told = substr($0, 2, RLENGTH - 2); sub("/", " of ", told); next }
        match($0, /^ *[0-9]+\/[0-9]+ Test +#/) { told = $1; sub("/", " of ", told); tests = 1; next }
        NF { last = $0 }
        END { print told == "" ? substr(last, 1, 60) : tests ? told ", " failed + 0 " failed" : told }' "$1" 2>/dev/null
}

# The words before a command that needs the administrator; fails where there is no way.
as_administrator() {
    if [ "$(id -u)" = 0 ]; then
        say ""
    elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
        say "sudo -n"
    elif command -v sudo >/dev/null 2>&1 && [ -t 0 ] && [ -t 2 ]; then
        say "sudo"
    else
        return 1
    fi
}

print_packages() {  # print_packages NEED...
    local brew brew_vcpkg word vcpkg
    brew=
    brew_vcpkg=
    for word in $(column_of_missing 6 "$@"); do
        case $word in
            vcpkg:*) brew_vcpkg="$brew_vcpkg ${word#vcpkg:}" ;;
            *) brew="$brew $word" ;;
        esac
    done
    vcpkg=$(column_of_missing 7 "$@")
    say "  Debian     sudo apt-get update && sudo apt-get install $(column_of_missing 3 "$@")"
    say "  Fedora     sudo dnf install $(column_of_missing 4 "$@")"
    say "  Arch       sudo pacman -S $(column_of_missing 5 "$@")"
    say "  Homebrew   brew install$brew${brew_vcpkg:+   (not in Homebrew, take them from vcpkg:$brew_vcpkg)}"
    if [ -n "$vcpkg" ]; then
        say "  vcpkg      vcpkg install $vcpkg   (then export VCPKG_ROOT, and" \
            "CMAKE_TOOLCHAIN_FILE=\$VCPKG_ROOT/scripts/buildsystems/vcpkg.cmake; tools from the system)"
    fi
    say "The names for Debian are tested. The other names come from the lists of those systems and are untested." \
        "What lies in a place of its own is found through CMAKE_PREFIX_PATH."
}

# Installs what is missing among the needs named, or says what is to be installed and stops.
install_missing() {  # install_missing NEED...
    local manager column packages sudo log word
    [ -n "$(column_of_missing 1 "$@")" ] || return 0
    manager=none
    for word in apt-get dnf pacman brew; do
        if [ "$manager" = none ] && command -v $word >/dev/null 2>&1; then manager=$word; fi
    done
    case $manager in
        apt-get) column=3 ;;
        dnf) column=4 ;;
        pacman) column=5 ;;
        brew) column=6 ;;
        none) stop "These are missing: $(column_of_missing 1 "$@")" "This script can use no package manager of this system. The packages of each system are:" \
            "$(print_packages "$@")" ;;
    esac
    packages=$(column_of_missing $column "$@")
    sudo=
    if [ $manager != brew ] && ! sudo=$(as_administrator); then
        stop "These are missing: $(column_of_missing 1 "$@")" "Installing needs root or sudo, and there is neither. Please install:" \
            "$(print_packages "$@")"
    fi
    case $packages in
        *vcpkg:*) stop "These are missing: $(column_of_missing 1 "$@")" "Please install:" "$(print_packages "$@")" ;;
    esac
    [ $manager = apt-get ] || say "The names for $manager are untested: one of them may be wrong."
    say "$manager installs these packages, usually in one to five minutes: $packages"
    log=$(mktemp)
    # shellcheck disable=SC2086  # lists of words
    with_progress "$log" install_with "$manager" "$sudo" "$log" $packages || true
    if [ -n "$(column_of_missing 1 "$@")" ]; then
        explain_failure "$log" "The package servers"
        rm -f "$log"
        stop "$manager has not installed what is needed. These are still missing: $(column_of_missing 1 "$@")"
    fi
    rm -f "$log"
}

install_with() {  # install_with MANAGER SUDO LOG PACKAGE...
    local manager=$1 sudo=$2 log=$3
    shift 3
    case $manager in
        apt-get) apt_install "$sudo" "$log" "$@" ;;
        dnf) $sudo dnf install -y "$@" >"$log" 2>&1 ;;
        pacman) $sudo pacman -Sy --needed --noconfirm "$@" >"$log" 2>&1 ;;
        brew) brew install "$@" >"$log" 2>&1 ;;
    esac
}

# The end of a log, and whether it reports a missing network.
explain_failure() {  # explain_failure LOG SERVERS
    tail -n 5 "$1" >&2
    if grep -Eiq 'could not resolve|temporary failure|(unable|failed|could not) to connect|could not connect' "$1" ||
        grep -Eiq 'network is unreachable|connection (refused|timed out)|ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ETIMEDOUT' "$1"; then
        say "$2 could not be reached: check the network." >&2
    fi
}

# apt-get installs nothing at all when one name of a list is unknown: ask for the known ones only.
apt_install() {  # apt_install SUDO LOG PACKAGE...
    local sudo=$1 log=$2 package known=''
    shift 2
    if [ -z "${typemesh_lists_are_new:-}" ]; then
        $sudo apt-get -o DPkg::Lock::Timeout=300 update >>"$log" 2>&1 || true
        typemesh_lists_are_new=yes
    fi
    for package in "$@"; do
        if apt-cache show --no-all-versions "$package" >/dev/null 2>&1; then
            known="$known $package"
        else
            say "The package lists of this system have no package $package" | tee -a "$log" >&2
        fi
    done
    # shellcheck disable=SC2086  # a list of words
    [ -z "$known" ] || $sudo env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 \
        install -y --no-install-recommends $known >>"$log" 2>&1
}

is_installed() {  # is_installed DEBIAN_PACKAGE; on another system none is
    dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed
}

# Fonts, and other data, that tests look for. Without them the tests that need them say so; nothing stops.
install_fonts() {  # install_fonts DEBIAN_PACKAGE...
    local package missing='' sudo log
    for package in "$@"; do
        is_installed "$package" || missing="$missing $package"
    done
    [ -n "$missing" ] || return 0
    if ! command -v apt-get >/dev/null 2>&1 || ! sudo=$(as_administrator); then
        say "These Debian packages are not installed, and tests that need them will report it:$missing"
        return 0
    fi
    say "apt-get installs fonts and data, usually in a minute or two:$missing"
    log=$(mktemp)
    # shellcheck disable=SC2086
    if ! with_progress "$log" apt_install "$sudo" "$log" $missing; then
        explain_failure "$log" "The package servers"
        say "Not all of them could be installed, and tests that need them will report it:$missing" >&2
    fi
    rm -f "$log"
}

# Puts the Unicode Character Database of the version that the tables are made of into build/, where the system's own is
# another: from the newest Debian that this system's own servers have. Its package lists and the package stay in scratch
# state, nothing of the system changes and no administrator is needed. Without it the tests that need it say so.
install_unicode_data() {
    local version folder scratch
    [ -z "${TYPEMESH_UNICODE_DATA:-}" ] || return 0
    version=$(sed -n 's/^inline const std::string version = "\(.*\)";$/\1/p' "$typemesh_root/tests/unicode/character_database.hpp")
    folder=$typemesh_root/build/unicode-data-$version
    [ ! -e "$folder/BidiTest.txt" ] || return 0
    ! head -n 1 /usr/share/unicode/BidiTest.txt 2>/dev/null | grep -q -F "$version" || return 0
    scratch=$(mktemp -d)
    say "This fetches the Unicode Character Database $version, usually in some seconds"
    if fetch_unicode_data "$version" "$scratch" >"$scratch/log" 2>&1; then
        mkdir -p "$typemesh_root/build"
        rm -rf "$folder"
        mv "$scratch/unicode" "$folder"
    else
        say "It could not be fetched (Debian package unicode-data $version), and tests that need it will report it:"
        tail -n 3 "$scratch/log" | sed 's,^,  ,'
    fi
    rm -rf "$scratch"
}

fetch_unicode_data() {  # fetch_unicode_data VERSION SCRATCH; leaves it in SCRATCH/unicode
    local version=$1 scratch=$2 server suite keys=/usr/share/keyrings/debian-archive-keyring.gpg package options
    command -v apt-get && command -v dpkg-deb || { say "There is no apt-get." && return 1; }
    mkdir -p "$scratch/lists/partial" "$scratch/cache/archives/partial"
    options=(-o "Dir::State::lists=$scratch/lists" -o "Dir::Cache=$scratch/cache" -o "Dir::Etc::sourcelist=$scratch/list"
        -o Dir::Etc::sourceparts=- -o APT::Sandbox::User="$(id -un)" -o Acquire::Languages=none -o Acquire::Retries=1)
    for server in $(apt-get indextargets --format '$(REPO_URI) $(ORIGIN)' 'Created-By: Packages' |
        awk '$2 == "Debian" && $1 !~ /security/ { print $1 }' | sort -u); do
        for suite in forky sid; do
            say "deb [signed-by=$keys] $server $suite main" >"$scratch/list"
            apt-get "${options[@]}" update || continue
            (cd "$scratch" && apt-get "${options[@]}" download unicode-data) || continue
            for package in "$scratch"/unicode-data_"$version"-*.deb; do
                dpkg-deb -x "$package" "$scratch/files" || continue
                rm -f "$scratch"/files/usr/share/unicode/*.bz2 "$scratch"/files/usr/share/unicode/*/*.html
                mv "$scratch/files/usr/share/unicode" "$scratch/unicode" && return 0
            done
        done
    done
    say "No package server of this system has it."
    return 1
}

# Stops where nothing can be built.
need_build_folder() {  # need_build_folder PRESET
    local build=$typemesh_root/build
    if ! { mkdir -p "$build/$1" && [ -w "$build/$1" ] && : >>"$build/$1.log"; } 2>/dev/null; then
        stop "The build folder $build cannot be written: give it to $(id -un), or copy the sources to a folder that is yours."
    fi
}

# Configures a preset and builds the targets named (all of them by default), going on after an error as far as possible.
# The compiler's words go to build/PRESET.log and, after an error, to the screen. TYPEMESH_CMAKE_OPTIONS: more for CMake.
build_preset() {  # build_preset PRESET [TARGET...]
    local preset=$1 folder=$typemesh_root/build/$1 log=$typemesh_root/build/$1.log go_on=-k status=0
    shift
    if [ -z "${CMAKE_GENERATOR:-}" ] && command -v ninja >/dev/null 2>&1; then
        export CMAKE_GENERATOR=Ninja  # a folder configured before keeps its own
    fi
    need_build_folder "$preset"
    # shellcheck disable=SC2086  # a list of words
    if ! (cd "$typemesh_root" && cmake --preset "$preset" ${TYPEMESH_CMAKE_OPTIONS:-}) >"$log" 2>&1; then
        tail -n 40 "$log" >&2
        return 1
    fi
    [ ! -e "$folder/build.ninja" ] || go_on=-k0
    with_progress "$log" logged "$log" \
        cmake --build "$folder" --parallel "$(processors)" ${1:+--target "$@"} -- $go_on || status=$?
    if [ $status != 0 ]; then
        grep -E -A 12 '(^|: )(fatal )?error: |undefined reference|CMake Error' "$log" | head -n 120 >&2 || true
        say "The build has failed: read its full output in $log" >&2
    fi
    return $status
}

processors() { getconf _NPROCESSORS_ONLN 2>/dev/null || say 2; }
