// SPDX-License-Identifier: MIT
//
// Coin's SoText3, by a callback for each triangle. Coin keeps letters, and crashes where it is made to forget them, so that it is only
// timed warm; it also crashes on texts beyond ASCII, which are left out.

#include "peer_program.hpp"

#include <Inventor/SoDB.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoFont.h>
#include <Inventor/nodes/SoLinearProfile.h>
#include <Inventor/nodes/SoProfileCoordinate2.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoText3.h>
#include <fontconfig/fontconfig.h>

#include <memory>

namespace {

struct scene {
    SoSeparator* root = new SoSeparator;
    SoComplexity* complexity = new SoComplexity;
    SoText3* text = new SoText3;
    SoCallbackAction action;
    peers::mesh found;
    std::vector<SbVec3f> normals;

    explicit scene(const std::string& family)
    {
        root->ref();
        auto* font = new SoFont;
        font->name.setValue(family.c_str());
        font->size.setValue(1.0f);
        auto* depth = new SoProfileCoordinate2;
        depth->point.set1Value(0, 0.0f, 0.0f);
        depth->point.set1Value(1, float(peers::depth), 0.0f);
        auto* profile = new SoLinearProfile;
        profile->index.set1Value(0, 0);
        profile->index.set1Value(1, 1);
        text->parts.setValue(SoText3::ALL);
        for (SoNode* node : {static_cast<SoNode*>(complexity), static_cast<SoNode*>(font), static_cast<SoNode*>(depth),
                             static_cast<SoNode*>(profile), static_cast<SoNode*>(text)})
            root->addChild(node);
        action.addTriangleCallback(SoText3::getClassTypeId(), collect, this);
    }
    scene(const scene&) = delete;
    ~scene() { root->unref(); }

    static void collect(void* self, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
                        const SoPrimitiveVertex* c)
    {
        auto& s = *static_cast<scene*>(self);
        for (const SoPrimitiveVertex* v : {a, b, c}) {
            s.found.corners.push_back(std::uint32_t(s.found.vertices()));
            for (int i = 0; i < 3; ++i) s.found.points.push_back(v->getPoint()[i]);
            s.normals.push_back(v->getNormal());
        }
    }

    bool build(const std::string& utf8)
    {
        for (const char c : utf8)
            if (static_cast<unsigned char>(c) > 0x7E) return false;
        found.points.clear(), found.corners.clear(), normals.clear();
        text->string.setValue(utf8.c_str());
        action.apply(root);
        return !found.corners.empty();
    }
};

std::string family_of(const std::string& file)
{
    int faces = 0;
    FcChar8* family = nullptr;
    FcPattern* font = FcFreeTypeQuery(reinterpret_cast<const FcChar8*>(file.c_str()), 0, nullptr, &faces);
    if (font == nullptr || FcPatternGetString(font, FC_FAMILY, 0, &family) != FcResultMatch) return {};
    std::string name = reinterpret_cast<const char*>(family);
    FcPatternDestroy(font);
    return name;
}

std::vector<peers::way> open(const std::string& file)
{
    const std::string family = family_of(file);  // it knows fonts by the name of their family
    std::vector<peers::way> ways;
    for (const float fineness : {0.2f, 0.3f}) {
        char setting[32];
        std::snprintf(setting, sizeof setting, "complexity %.1f", double(fineness));
        const auto one = std::make_shared<scene>(family);
        one->complexity->value.setValue(fineness);
        ways.push_back({setting, "extruded", "warm", [one](const std::string& text) { return one->build(text); },
                        [one] { return one->found; }});
    }
    return ways;
}

}  // namespace

int main(int argc, char** argv)
{
    SoDB::init();
    return peers::run(argc, argv, "Coin", open);
}
