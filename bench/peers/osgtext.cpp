// SPDX-License-Identifier: MIT
//
// OpenSceneGraph's osgText: the solids of its letters, and Text3D, which places those that it keeps.

#include "peer_program.hpp"

#include <osg/Notify>
#include <osg/TriangleIndexFunctor>
#include <osgText/Font>
#include <osgText/Text3D>

#include <memory>

namespace {

// osgText gives letters a height of 1 an em.
struct letters {
    osg::ref_ptr<osgText::Font> font;
    osg::ref_ptr<osgText::Style> style;
    osgText::FontResolution size{32, 32};
    std::vector<osg::ref_ptr<osgText::Glyph3D>> glyphs;  ///< of the last text
    std::vector<float> pens;

    unsigned samples = 10;

    /// The letters anew, from the font's outlines: the font's own list of glyphs is passed by.
    bool build(const std::string& text)
    {
        font->setNumberCurveSamples(samples);
        glyphs.clear(), pens.clear();
        float pen = 0;
        for (const char32_t c : peers::characters_of(text)) {
            osg::ref_ptr<osgText::Glyph3D> glyph = font->getImplementation()->getGlyph3D(size, c);
            if (!glyph) continue;
            glyph->getGlyphGeometry(style.get());
            pens.push_back(pen);
            pen += glyph->getHorizontalAdvance();
            glyphs.push_back(glyph);
        }
        return !glyphs.empty();
    }

    peers::mesh made() const;
};

struct collect_triangles {
    std::vector<std::uint32_t>* corners = nullptr;
    std::uint32_t base = 0;

    void operator()(unsigned a, unsigned b, unsigned c)
    {
        for (const unsigned i : {a, b, c}) corners->push_back(base + i);
    }
};

peers::mesh letters::made() const
{
    peers::mesh m;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        osgText::GlyphGeometry* solid = glyphs[i]->getGlyphGeometry(style.get());
        osg::TriangleIndexFunctor<collect_triangles> collect;
        collect.corners = &m.corners;
        collect.base = std::uint32_t(m.vertices());
        if (solid == nullptr || !solid->getGeometry()) continue;
        solid->getGeometry()->accept(collect);
        for (const osg::Vec3& p : *solid->getVertexArray())
            for (const float x : {p.x() + pens[i], p.y(), p.z()}) m.points.push_back(x);
    }
    return m;
}

std::vector<peers::way> open(const std::string& file)
{
    osg::ref_ptr<osgText::Font> font = osgText::readRefFontFile(file);
    if (!font || font->getImplementation() == nullptr) return {};
    std::vector<peers::way> ways;
    const auto add = [&](const std::string& setting, const char* solid, unsigned samples, bool bevelled) {
        auto one = std::make_shared<letters>();
        one->font = font;
        one->style = new osgText::Style;
        one->style->setThicknessRatio(float(peers::depth));
        one->samples = samples;
        if (bevelled) {
            osg::ref_ptr<osgText::Bevel> bevel = new osgText::Bevel;
            bevel->roundedBevel2(0.25f, 3);
            bevel->setBevelThickness(float(peers::bevel_width));
            one->style->setBevel(bevel);
        }
        ways.push_back({setting, solid, "cold", [one](const std::string& text) { return one->build(text); },
                        [one] { return one->made(); }});
    };
    add("10 samples a curve", "extruded", 10, false);
    add("5 samples a curve", "extruded", 5, false);
    add("5 samples a curve", "bevelled", 5, true);
    osg::ref_ptr<osgText::Text3D> placed = new osgText::Text3D;
    placed->setFont(font);
    placed->setCharacterDepth(float(peers::depth));
    ways.push_back({"10 samples a curve",
                    "extruded",
                    "placed",
                    [placed](const std::string& text) {
                        placed->setText("");  // the same text again would be no work
                        placed->setText(text, osgText::String::ENCODING_UTF8);
                        return true;
                    },
                    {}});
    return ways;
}

}  // namespace

int main(int argc, char** argv)
{
    osg::setNotifyLevel(osg::FATAL);  // it complains of every space
    return peers::run(argc, argv, "osgText 3D", open);
}
