// The built-in styles, each recorded as a user makes it.
#pragma once

#include "recording.h"

#include <QStringList>

#include <map>
#include <string>
#include <vector>

namespace hairpaint::presets {

struct Style
{
    const char* id; ///< File name.
    const char* name;
    QStringList tags;
    sim::GroupSettings settings;
    void (*record)(Recording& user);
    const char* kind = "Scalp"; ///< Hair kind that it is made of, see grownHair().
};

[[nodiscard]] Style longStraight();
[[nodiscard]] Style bob();
[[nodiscard]] Style ringlets();
[[nodiscard]] Style afro();
[[nodiscard]] Style twoPlaits();
[[nodiscard]] Style mohawk();
[[nodiscard]] Style splitDye();
[[nodiscard]] Style buzzCut();
[[nodiscard]] Style slickedUndercut();
[[nodiscard]] Style quiff();
[[nodiscard]] Style sidePart();
[[nodiscard]] Style frenchCrop();
[[nodiscard]] Style highPonytail();
[[nodiscard]] Style lowBun();
[[nodiscard]] Style halfUp();
[[nodiscard]] Style twinTails();
[[nodiscard]] Style topKnot();
[[nodiscard]] Style fishtail();
[[nodiscard]] Style boxBraids();
[[nodiscard]] Style cornrows();
[[nodiscard]] Style locs();
[[nodiscard]] Style pixie();
[[nodiscard]] Style curtainLayers();
[[nodiscard]] Style jawBob();
[[nodiscard]] Style beachWaves();
[[nodiscard]] Style wolfCut();
[[nodiscard]] Style shag();
[[nodiscard]] Style curlyBob();
[[nodiscard]] Style curlyTop();
[[nodiscard]] Style highTop();
[[nodiscard]] Style libertySpikes();
[[nodiscard]] Style lineUp();
[[nodiscard]] Style lowPonytail();
[[nodiscard]] Style stubble();
[[nodiscard]] Style goatee();
[[nodiscard]] Style fullBeard();
[[nodiscard]] Style hime();
[[nodiscard]] Style headband();
[[nodiscard]] Style brows();
[[nodiscard]] Style bantuKnots();
[[nodiscard]] Style twistOut();
[[nodiscard]] Style waves360();
[[nodiscard]] Style crownBraid();

[[nodiscard]] std::vector<Style> builtInStyles(); ///< In the strip's order.

/// Hair as it grows, each kind once.
class GrownHair
{
public:
    [[nodiscard]] const model::HairGroup& of(const Style& style);

private:
    std::map<std::string, model::HairGroup> m_groups;
};

/// What the style's recording makes of it, without its picture.
[[nodiscard]] model::Preset played(const Style& style, GrownHair& grown);

/// What most of them have in common.
[[nodiscard]] sim::GroupSettings settingsOf(float greatestLengthM, float stiffnessM, float volumeM);

} // namespace hairpaint::presets
