// Through an edit session, with a question where it is needed.
#include "view/panels/style_fitting.h"

#include "model/styles/style_use.h"
#include "model/values/names.h"
#include "view/panels/style_question.h"

#include <algorithm>
#include <utility>

namespace hairpaint::view {

using model::Change;
using model::StylePart;

StyleFitting::StyleFitting(EditorState& state, StyleQuestion& question, QObject* parent)
    : QObject(parent), m_state(state), m_question(question)
{
    connect(&question, &StyleQuestion::keepChosen, this, [this] {
        if (const std::optional<Asked> asked = std::exchange(m_asked, std::nullopt))
            commit(asked->preset, asked->use);
    });
    connect(&question, &StyleQuestion::replaceChosen, this, [this] {
        if (const std::optional<Asked> asked = std::exchange(m_asked, std::nullopt)) {
            const model::StyleUse whole{.part = asked->use.part, .fraction = asked->use.fraction};
            showStyle(asked->preset, whole);
            commit(asked->preset, whole);
        }
    });
    connect(&question, &StyleQuestion::cancelChosen, this, &StyleFitting::dismiss);
    connect(&state.document(), &model::Document::editEnded, this, &StyleFitting::editEnded);
    connect(&state.document(), &model::Document::changed, this, [this](const Change& change) {
        if (change.aspect == Change::Aspect::Everything) {
            m_untouched.clear();
            m_kept.reset();
        }
    });
}

model::StyleUse StyleFitting::useOf(const model::Preset& preset, StylePart part) const
{
    const model::Project& project = m_state.document().committed();
    model::StyleUse use{.part = part, .kept = groupsContested(project, preset), .fraction = m_fraction};
    std::erase_if(use.kept, [&](model::Id id) {
        const auto known = m_untouched.find(id);
        return known != m_untouched.end() && known->second == *project.group(id);
    });
    return use;
}

void StyleFitting::setFraction(double fraction)
{
    m_fraction = fraction;
    if (m_asked)
        return;
    const model::Project& project = m_state.document().committed();
    if (!m_kept || m_kept->groupsAfter != project.groups || m_kept->wornAfter != project.worn)
        return;
    begin();
    m_mixes = true;
    m_kept->use.fraction = fraction;
    m_state.document().show(m_edit, {.text = applyPresetText(*m_kept->preset, m_kept->use.part, fraction)},
                            {.aspect = Change::Aspect::GroupList}, [kept = *m_kept](model::Project& shown) {
                                shown.groups = kept.groupsBefore;
                                shown.worn = kept.wornBefore;
                                applyPreset(shown, *kept.preset, kept.use);
                            });
}

void StyleFitting::letGo()
{
    keepFraction();
    m_kept.reset();
}

void StyleFitting::keepFraction()
{
    if (!std::exchange(m_mixes, false) || !m_edit.active())
        return;
    m_before.reset();
    m_edit.setText(applyPresetText(*m_kept->preset, m_kept->use.part, m_fraction));
    m_edit.commit();
    remember();
}

void StyleFitting::takeFractionBack(double fraction)
{
    m_fraction = fraction;
    if (!std::exchange(m_mixes, false))
        return;
    m_kept->use.fraction = fraction;
    m_edit.drop();
}

void StyleFitting::remember()
{
    const model::Project& project = m_state.document().committed();
    m_kept->groupsAfter = project.groups;
    m_kept->wornAfter = project.worn;
    for (const model::Id id : groupsReplaced(project, *m_kept->preset))
        if (std::ranges::find(m_kept->use.kept, id) == m_kept->use.kept.end() && m_kept->use.part == StylePart::All)
            m_untouched.insert_or_assign(id, *project.group(id));
}

void StyleFitting::show(const PresetPtr& preset, StylePart part)
{
    if (m_asked)
        return;
    begin();
    showStyle(preset, useOf(*preset, part));
}

void StyleFitting::drop()
{
    if (!m_asked)
        m_edit.drop();
}

void StyleFitting::begin()
{
    if (m_edit.active())
        return;
    m_state.document().endEdit(); // First: the end of another one's edit is not the end of this.
    m_before = m_state.target().address();
}

void StyleFitting::editEnded()
{
    if (m_edit.active())
        return;
    m_mixes = false;
    m_asked.reset();
    m_question.close();
    if (!m_before)
        return;
    const model::LayerAddress before = *std::exchange(m_before, std::nullopt);
    m_state.target().setGroup(before.group);
    if (m_state.target().group() == before.group && m_state.target().map() == before.map)
        m_state.target().setLayer(before.layer);
}

void StyleFitting::showStyle(const PresetPtr& preset, const model::StyleUse& use)
{
    // Only looked at: whoever changes something else goes on from the hair that was there.
    m_state.document().show(m_edit, {.policy = model::EditPolicy::Drop}, {.aspect = Change::Aspect::GroupList},
                            [preset, use](model::Project& project) { applyPreset(project, *preset, use); });
}

void StyleFitting::putOn(const PresetPtr& preset, StylePart part)
{
    m_asked.reset();
    m_question.close();
    if (part != StylePart::All && groupsReplaced(m_state.document().committed(), *preset).empty()) {
        m_edit.drop();
        return Q_EMIT failed(tr("'%1' has no part for the hair of this head; click it to put all of it on.")
                                 .arg(model::shownName(preset->name)));
    }
    begin();
    const model::StyleUse use = useOf(*preset, part);
    showStyle(preset, use);
    if (use.kept.empty())
        commit(preset, use);
    else
        ask(preset, use);
}

void StyleFitting::ask(const PresetPtr& preset, const model::StyleUse& use)
{
    QStringList names;
    for (const model::Id id : use.kept)
        names.append(model::shownName(m_state.document().committed().group(id)->name));
    m_asked = Asked{.preset = preset, .use = use};
    Q_EMIT asking();
    m_question.ask(model::shownName(preset->name), names);
}

void StyleFitting::commit(const PresetPtr& preset, const model::StyleUse& use)
{
    m_edit.setText(applyPresetText(*preset, use.part, use.fraction));
    m_before.reset(); // The style's own is kept.
    const model::Project& before = m_state.document().committed();
    m_kept = Kept{.preset = preset,
                  .use = use,
                  .groupsBefore = before.groups,
                  .groupsAfter = {},
                  .wornBefore = before.worn,
                  .wornAfter = {}};
    m_edit.commit();
    m_question.close();
    remember();
    // On a bald head only Density makes hair.
    const auto density = m_state.document().resolvedNow(m_state.target().group(), model::MapKind::Density);
    if (density != nullptr && density->uniformValue() == sim::Texel{})
        m_state.target().setMap(model::MapKind::Density);
    Q_EMIT kept();
}

} // namespace hairpaint::view
