# SPDX-License-Identifier: MIT
#
# The recipe of docs/engines.md fills a vtkPolyData; VTK finds no open edge in it.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
headers=
for folder in /usr/include/vtk-9* /usr/local/include/vtk-9*; do
    [ ! -e "$folder/vtkPolyData.h" ] || headers=$folder
done
[ -n "$headers" ] || skip "VTK 9 is not installed (with all that it needs 750 MB: it is not installed by this tier)"
version=-${headers##*vtk-}
libraries=
for library in FiltersCore CommonDataModel CommonExecutionModel CommonCore; do
    libraries="$libraries -lvtk$library$version"
done
# shellcheck disable=SC2086  # a list of words
compile_tests "$scratch/vtk" -isystem "$headers" "$here/vtk.cpp" "$root/tests/compile/vtk_snippets.cpp" $libraries
"$scratch/vtk"
