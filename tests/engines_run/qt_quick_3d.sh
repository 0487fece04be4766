# SPDX-License-Identifier: MIT
#
# The recipe of docs/engines.md fills a QQuick3DGeometry.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
pkg-config --exists Qt6Quick3D 2>/dev/null || skip "Qt Quick 3D 6 is not installed"
compile_tests "$scratch/qt" "$here/qt_quick_3d.cpp" "$root/tests/compile/qt_snippets.cpp" -fPIC $(flags_of Qt6Quick3D)
QT_QPA_PLATFORM=offscreen "$scratch/qt"
