// SPDX-License-Identifier: MIT
//
// Qt 3D's QExtrudedTextGeometry. Its curves are flattened to a quarter of a pixel of the font's size.

#include "peer_program.hpp"

#include <Qt3DExtras/QExtrudedTextGeometry>
#include <Qt3DRender/QAttribute>
#include <Qt3DRender/QBuffer>
#include <QtGui/QFontDatabase>
#include <QtGui/QGuiApplication>

#include <map>
#include <memory>

namespace {

const char* bytes_of(const Qt3DRender::QAttribute* attribute, const QByteArray& data)
{
    return data.constData() + attribute->byteOffset();
}

peers::mesh made(const Qt3DExtras::QExtrudedTextGeometry& geometry, float em)
{
    peers::mesh m;
    const auto *positions = geometry.positionAttribute(), *indices = geometry.indexAttribute();
    const QByteArray points = positions->buffer()->data(), corners = indices->buffer()->data();
    for (unsigned i = 0; i < positions->count(); ++i) {
        float p[3];
        std::memcpy(p, bytes_of(positions, points) + i * positions->byteStride(), sizeof p);
        for (const float x : {-p[0], -p[1], p[2]}) m.points.push_back(x / em);  // it comes turned by half a turn
    }
    for (unsigned i = 0; i < indices->count(); ++i) {
        std::uint32_t corner = 0;
        const unsigned size = indices->vertexBaseType() == Qt3DRender::QAttribute::UnsignedShort ? 2 : 4;
        std::memcpy(&corner, bytes_of(indices, corners) + i * size, size);
        m.corners.push_back(corner);
    }
    return m;
}

std::vector<peers::way> open(const std::string& file)
{
    const int id = QFontDatabase::addApplicationFont(QString::fromStdString(file));
    const QStringList families = QFontDatabase::applicationFontFamilies(id);
    if (families.isEmpty()) return {};
    std::vector<peers::way> ways;
    for (const int pixels : {32, 220, 400}) {
        QFont font(families.front());
        font.setPixelSize(pixels);
        font.setHintingPreference(QFont::PreferNoHinting);
        const auto geometry = std::make_shared<Qt3DExtras::QExtrudedTextGeometry>();
        geometry->setFont(font);
        geometry->setDepth(float(peers::depth) * float(pixels));
        ways.push_back({"quarter pixels, " + std::to_string(pixels) + " an em", "extruded", "cold",
                        [geometry](const std::string& text) {
                            geometry->setText({});  // the same text again would be no work
                            geometry->setText(QString::fromStdString(text));
                            return geometry->indexAttribute()->count() > 0;
                        },
                        [geometry, pixels] { return made(*geometry, float(pixels)); }});
    }
    return ways;
}

}  // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QGuiApplication application(argc, argv);
    return peers::run(argc, argv, "Qt 3D", open);
}
