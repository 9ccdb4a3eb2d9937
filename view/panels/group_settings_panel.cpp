// A control for each row of the schema.
#include "view/panels/group_settings_panel.h"

#include "model/document/group_commands.h"
#include "model/document/hair_type_command.h"
#include "model/project/group_schema.h"
#include "model/project/hair_types.h"
#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/look/value_text.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>

namespace hairpaint::view {

using model::Change;
using model::GroupSetting;
using model::schemaText;
using model::SettingSection;
using sim::GroupSettings;
using sim::TurnsMode;

namespace {

/// Settings without effect on the curls that the group has are not shown.
bool isShown(const GroupSetting& row, const GroupSettings& settings)
{
    const bool areCoils = settings.turnsMode == TurnsMode::Coils;
    if (row.member == model::SettingMember(&GroupSettings::turnsPerLengthM))
        return settings.turnsMode == TurnsMode::PerLength;
    if (row.member == model::SettingMember(&GroupSettings::steppedTurns) ||
        row.member == model::SettingMember(&GroupSettings::greatestCurlRadiusM))
        return !areCoils;
    return row.section != SettingSection::Curl || areCoils ||
           row.member == model::SettingMember(&sim::CurlSettings::gather);
}

} // namespace

GroupSettingsPanel::GroupSettingsPanel(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    build();
    connect(&state.target(), &EditTarget::changed, this, &GroupSettingsPanel::follow);
    connect(&state.document(), &model::Document::changed, this, [this](const Change& change) {
        switch (change.aspect) {
        case Change::Aspect::Settings:
        case Change::Aspect::Head: // Counts are shown for its scalp.
        case Change::Aspect::GroupList:
        case Change::Aspect::Everything:
            follow();
            break;
        default:
            break;
        }
    });
    follow();
}

void GroupSettingsPanel::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGrid);
    const std::pair<SettingSection, QString> titles[] = {
        {SettingSection::Shape, tr("Shape")},  {SettingSection::Curl, tr("Curl")},
        {SettingSection::Locks, tr("Locks")},  {SettingSection::Variation, tr("Variation")},
        {SettingSection::Braid, tr("Braids")}, {SettingSection::Physics, tr("Motion")},
        {SettingSection::Look, tr("Look")}};
    for (const auto& [kind, title] : titles) {
        auto* section = new Section(title, this);
        if (kind == SettingSection::Curl)
            section->body().addWidget(makeHairTypes(section));
        for (const GroupSetting& row : model::groupSchema()) {
            if (row.section != kind)
                continue;
            if (!row.choices.empty())
                section->body().addWidget(makeChoice(row, section));
            else if (row.isSwitch())
                section->body().addWidget(makeSwitch(row, section));
            else
                section->body().addWidget(makeSlider(row, section));
        }
        column->addWidget(section);
    }
}

QWidget* GroupSettingsPanel::makeChoice(const GroupSetting& row, QWidget* parent)
{
    auto* box = new QComboBox(parent);
    box->setAccessibleName(schemaText(row.hint));
    box->setToolTip(box->accessibleName());
    for (const model::SettingChoice& choice : row.choices)
        box->addItem(schemaText(choice.title));
    connect(box, &QComboBox::activated, this, [this, &row](int index) { change(row, index); });
    m_followers.emplace_back(
        [box, &row](const GroupSettings& settings) { box->setCurrentIndex(static_cast<int>(row.read(settings))); });
    return box;
}

QWidget* GroupSettingsPanel::makeHairTypes(QWidget* parent)
{
    auto* line = new QWidget(parent);
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kGap);
    auto* label = new QLabel(tr("Hair type"), line);
    auto* box = new QComboBox(line);
    box->setObjectName(QStringLiteral("hairType"));
    box->setAccessibleName(tr("Hair type"));
    box->setToolTip(tr("From straight (1) by wavy (2) and curly (3) to coily (4): sets the numbers below"));
    // The entry "Custom" is there only while the numbers match no type: it is not to be chosen.
    const auto fill = [box](bool isCustom) {
        box->clear();
        for (const model::HairType& type : model::hairTypes())
            box->addItem(QLatin1StringView(type.name));
        if (isCustom)
            box->addItem(tr("Custom"));
    };
    fill(true);
    label->setBuddy(box);
    layout->addWidget(label);
    layout->addWidget(box, 1);
    connect(box, &QComboBox::activated, this, [this](int index) {
        if (index < static_cast<int>(model::hairTypes().size()))
            setHairType(static_cast<std::size_t>(index));
    });
    m_followers.emplace_back([box, fill](const GroupSettings& settings) {
        const auto count = static_cast<int>(model::hairTypes().size());
        const std::optional<std::size_t> type = model::hairTypeOf(settings);
        if ((box->count() > count) != !type)
            fill(!type);
        box->setCurrentIndex(type ? static_cast<int>(*type) : count);
    });
    return line;
}

void GroupSettingsPanel::setHairType(std::size_t index)
{
    const model::HairGroup* edited = group();
    if (edited == nullptr)
        return;
    const QString text = tr("Hair type of \"%1\"").arg(model::shownName(edited->name));
    m_state.document().push(model::setHairTypeCommand(m_state.document(), edited->id, model::hairTypes()[index], text));
}

QWidget* GroupSettingsPanel::makeSwitch(const GroupSetting& row, QWidget* parent)
{
    auto* box = new QCheckBox(schemaText(row.hint), parent);
    connect(box, &QCheckBox::clicked, this, [this, &row](bool on) { change(row, on ? 1.0 : 0.0); });
    m_followers.emplace_back([box, &row](const GroupSettings& settings) {
        box->setChecked(row.read(settings) != 0.0);
        box->setVisible(isShown(row, settings));
    });
    return box;
}

QWidget* GroupSettingsPanel::makeSlider(const GroupSetting& row, QWidget* parent)
{
    auto* slider = new BarSlider(schemaText(row.label), parent);
    slider->setRange(row.sliderLeast, row.sliderGreatest, row.decimals);
    slider->setExponent(row.exponent);
    slider->setUnit(schemaText(row.unit));
    slider->setHint(schemaText(row.hint));
    // A session a slider: moving one ends, and keeps, what another one left open.
    auto session = std::make_shared<model::EditSession>();
    auto edited = std::make_shared<model::Id>(0); // Stays the same when another group becomes active meanwhile.
    const auto show = [this, &row, session, edited](double value) {
        if (!session->active())
            m_state.document().endEdit(); // What somebody only looks at may have another group.
        const model::HairGroup* shown = m_state.document().project().group(*edited);
        if (shown == nullptr)
            return;
        m_state.document().show(*session, {.text = settingText(row, *shown)},
                                {.aspect = Change::Aspect::Settings, .group = shown->id},
                                [id = shown->id, &row, value,
                                 fraction = m_state.document().project().scalpFraction()](model::Project& project) {
                                    if (model::HairGroup* one = project.group(id))
                                        row.writeShown(one->settings, value, fraction);
                                });
    };
    connect(slider, &BarSlider::editingBegan, this, [this, edited] { *edited = m_state.target().group(); });
    connect(this, &GroupSettingsPanel::groupChanged, slider, &BarSlider::release);
    if (model::setsRange(row)) {
        bindRange(*slider, row, session, edited);
    } else {
        connect(slider, &BarSlider::valueChanged, this, show);
        connect(slider, &BarSlider::editingFinished, this, [session] { session->commit(); });
        connect(slider, &BarSlider::editingCancelled, this, [session] { session->drop(); });
    }
    m_followers.emplace_back([this, slider, &row](const GroupSettings& settings) {
        slider->setDefaultValue(row.shown(model::newGroupSettings(scalpFraction()), scalpFraction()));
        slider->setValue(row.shown(settings, scalpFraction()));
        slider->setVisible(isShown(row, settings));
    });
    return slider;
}

void GroupSettingsPanel::bindRange(BarSlider& slider, const GroupSetting& row,
                                   const std::shared_ptr<model::EditSession>& session,
                                   const std::shared_ptr<model::Id>& edited)
{
    /// Most texels that are rescaled while the slider moves; more wait until it is let go.
    constexpr std::size_t kMostShownTexels = 4'000'000;
    auto change = std::make_shared<model::RangeChange>();
    auto waits = std::make_shared<bool>(false);
    const auto settingsAt = [this, &row](const model::HairGroup& before, double value) {
        GroupSettings settings = before.settings;
        row.writeShown(settings, value, scalpFraction());
        return settings;
    };
    const auto show = [this, &row, settingsAt, session, edited, change, waits](double value) {
        if (!session->active())
            m_state.document().endEdit(); // What somebody only looks at may have another group.
        const model::HairGroup* before = m_state.document().committed().group(*edited);
        if (before == nullptr)
            return;
        const GroupSettings settings = settingsAt(*before, value);
        *waits = texelsToRescale(*before, settings) > kMostShownTexels;
        if (*waits)
            return;
        *change = withRange(*before, settings);
        m_state.document().show(*session, {.text = settingText(row, *before)},
                                {.aspect = Change::Aspect::GroupList, .group = before->id},
                                [change = *change](model::Project& project) { change.applyTo(project); });
    };
    connect(&slider, &BarSlider::valueChanged, this, show);
    connect(&slider, &BarSlider::editingCancelled, this, [session, waits] {
        *waits = false;
        session->drop();
    });
    connect(&slider, &BarSlider::editingFinished, this,
            [this, &row, settingsAt, session, edited, change, waits](double value) {
                const model::HairGroup* before = m_state.document().committed().group(*edited);
                if (std::exchange(*waits, false) && before != nullptr) {
                    session->drop();
                    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
                    *change = withRange(*before, settingsAt(*before, value));
                    m_state.document().push(setRangeCommand(m_state.document(), *change, settingText(row, *before)));
                    QGuiApplication::restoreOverrideCursor();
                } else if (session->active()) {
                    session->commit();
                } else {
                    return; // Undo took it back meanwhile.
                }
                for (const model::RangeChange::Clamped& clamped : change->clamped)
                    tellClamped(*change, clamped);
            });
}

void GroupSettingsPanel::tellClamped(const model::RangeChange& change, const model::RangeChange::Clamped& clamped)
{
    const model::MapSpec& spec = model::mapSpec(clamped.map);
    const QString end = valueText(change.settings, spec, {.scalar = clamped.beyond ? 1.0F : 0.0F});
    m_state.tell((clamped.beyond ? tr("What was painted on %1 beyond %2 is %2 now; undo brings it back.")
                                 : tr("What was painted on %1 below %2 is %2 now; undo brings it back."))
                     .arg(spec.titleText(), end));
}

QString GroupSettingsPanel::settingText(const GroupSetting& row, const model::HairGroup& group)
{
    return tr("%1 of \"%2\"").arg(schemaText(row.label), model::shownName(group.name));
}

void GroupSettingsPanel::change(const GroupSetting& row, double value)
{
    m_state.document().endEdit();
    const model::Id id = m_state.target().group();
    const model::HairGroup* found = m_state.document().committed().group(id);
    if (found == nullptr)
        return;
    GroupSettings settings = found->settings;
    row.write(settings, value);
    m_state.document().push(setSettingsCommand(m_state.document(), id, settings, settingText(row, *found)));
}

void GroupSettingsPanel::follow()
{
    if (std::exchange(m_shownGroup, m_state.target().group()) != m_state.target().group())
        Q_EMIT groupChanged();
    const model::HairGroup* shown = group();
    setEnabled(shown != nullptr);
    if (shown == nullptr)
        return;
    for (const auto& follower : m_followers)
        follower(shown->settings);
}

const model::HairGroup* GroupSettingsPanel::group() const
{
    return m_state.document().project().group(m_state.target().group());
}

double GroupSettingsPanel::scalpFraction() const
{
    return m_state.document().project().scalpFraction();
}

} // namespace hairpaint::view
