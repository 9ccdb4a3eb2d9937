// Swatches of worn things, and the look of the chosen one.
#include "view/panels/worn_panel.h"

#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"
#include "view/widgets/section.h"
#include "view/widgets/swatch.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <memory>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr int kSwatchesARow = 8;
constexpr double kWornPercent = 100.0;
constexpr double kMmPerM = 1000.0;
constexpr double kLeastCoilMm = 10.0;
constexpr double kGreatestCoilMm = 100.0;

/// Name of the mesh that a user brought, or of the kind.
QString titleOf(const model::Worn& worn)
{
    return worn.ownMesh.own != nullptr ? worn.ownMesh.own->name : model::wornText(wornSpec(worn.kind).title);
}

} // namespace

WornPanel::WornPanel(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_all(new QGridLayout), m_look(new QWidget(this))
{
    auto* section = new Section(tr("Worn"), this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(section);
    m_all->setSpacing(metrics::kGrid);
    m_all->setAlignment(Qt::AlignLeft);
    section->body().addLayout(m_all);
    section->body().addWidget(m_look);

    auto* controls = new QVBoxLayout(m_look);
    controls->setContentsMargins(0, 0, 0, 0);
    controls->setSpacing(metrics::kGrid);
    m_name = new QLabel(m_look);
    m_name->setObjectName(QStringLiteral("wornName"));
    m_name->setTextFormat(Qt::PlainText);
    m_name->setWordWrap(true);
    controls->addWidget(m_name);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Colour"), m_look);
    label->setProperty("role", QStringLiteral("label"));
    m_colour = new Swatch(Qt::white, tr("Colour of what is worn"), m_look);
    m_colour->setObjectName(QStringLiteral("wornColour"));
    m_colour->setCheckable(false);
    label->setBuddy(m_colour);
    row->addWidget(label);
    row->addStretch(1);
    row->addWidget(m_colour);
    controls->addLayout(row);
    m_make = new QComboBox(m_look);
    m_make->setObjectName(QStringLiteral("wornMake"));
    m_make->setAccessibleName(tr("Made of"));
    m_make->setToolTip(tr("What it is made of"));
    controls->addWidget(m_make);
    m_sheen = new BarSlider(tr("Sheen"), m_look);
    m_sheen->setRange(0.0, kWornPercent);
    m_sheen->setUnit(QStringLiteral("%"));
    m_sheen->setHint(tr("How much light it reflects without taking its colour: 0 % is matt, 100 % polished"));
    controls->addWidget(m_sheen);
    m_radius = new BarSlider(tr("Radius"), m_look);
    m_radius->setUnit(tr("mm"));
    m_radius->setExponent(2.0);
    controls->addWidget(m_radius);

    m_tightness = new BarSlider(tr("Tightness"), m_look);
    m_tightness->setRange(0.0, kWornPercent);
    m_tightness->setUnit(QStringLiteral("%"));
    m_tightness->setHint(tr("How taut hair lies on the head before the tie: at 0 % as loose as a coat, at 100 % on the "
                            "skin"));
    m_tightness->setDefaultValue(kWornPercent);
    controls->addWidget(m_tightness);
    m_coil = new BarSlider(tr("Bun radius"), m_look);
    m_coil->setUnit(tr("mm"));
    m_coil->setRange(kLeastCoilMm, kGreatestCoilMm, 1);
    m_coil->setHint(tr("How far hair is wound about the tie"));
    controls->addWidget(m_coil);

    m_passable = new QCheckBox(tr("Hair goes through it"), m_look);
    m_passable->setObjectName(QStringLiteral("wornPassable"));
    m_passable->setToolTip(tr("Else hair keeps out of the ellipsoid in its box"));
    controls->addWidget(m_passable);
    connect(m_passable, &QCheckBox::clicked, this, &WornPanel::setPassable);

    connect(m_make, &QComboBox::activated, this, &WornPanel::choose);
    connect(m_colour, &Swatch::clicked, this, &WornPanel::chooseColour);
    bind(*m_sheen, &model::WornSpec::lookStep,
         [](model::Worn& worn, double value) { worn.sheen = static_cast<float>(value / kWornPercent); });
    bind(*m_radius, &model::WornSpec::sizeStep, [](model::Worn& worn, double value) {
        const model::WornSpec& spec = wornSpec(worn.kind);
        const float was = worn.shape.semiAxesM[spec.sizedAxis];
        const auto now = static_cast<float>(value / kMmPerM);
        if (spec.handles == model::WornHandles::Axes)
            worn.shape.semiAxesM[spec.sizedAxis] = now;
        else
            worn.shape.semiAxesM *= now / was;
        holdSize(worn);
    });
    bind(*m_tightness, &model::WornSpec::lookStep,
         [](model::Worn& worn, double value) { worn.tightness = static_cast<float>(value / kWornPercent); });
    bind(*m_coil, &model::WornSpec::sizeStep,
         [](model::Worn& worn, double value) { worn.coilRadiusM = static_cast<float>(value / kMmPerM); });
    connect(&state.options(), &ViewOptions::changed, this, &WornPanel::follow);
    connect(&state.document(), &model::Document::changed, this, [this](const model::Change& change) {
        using Aspect = model::Change::Aspect;
        if (change.aspect == Aspect::Environment || change.aspect == Aspect::Head ||
            change.aspect == Aspect::Everything)
            follow();
    });
    follow();
}

const model::Worn* WornPanel::chosen() const
{
    const model::Worn* worn = m_state.document().project().wornThing(m_state.options().chosenWorn());
    return worn != nullptr && wornSpec(worn->kind).drawn() ? worn : nullptr;
}

void WornPanel::showEdit(model::EditSession& session, model::Id id, Step step, const Edit& edit)
{
    const model::Worn* worn = m_state.document().project().wornThing(id);
    if (worn == nullptr)
        return;
    m_state.document().show(session, {.text = model::wornText(wornSpec(worn->kind).*step)},
                            {.aspect = model::Change::Aspect::Environment}, [id, edit](model::Project& project) {
                                if (model::Worn* one = project.wornThing(id))
                                    edit(*one);
                            });
}

void WornPanel::bind(BarSlider& slider, Step step, const std::function<void(model::Worn&, double)>& set)
{
    auto session = std::make_shared<model::EditSession>();
    auto edited = std::make_shared<model::Id>(0); // Also when another thing is chosen meanwhile.
    connect(&slider, &BarSlider::editingBegan, this, [this, edited] { *edited = m_shown; });
    connect(&slider, &BarSlider::valueChanged, this, [this, step, set, session, edited](double value) {
        showEdit(*session, *edited, step, [set, value](model::Worn& worn) { set(worn, value); });
    });
    connect(&slider, &BarSlider::editingFinished, this, [session] { session->commit(); });
    connect(&slider, &BarSlider::editingCancelled, this, [session] { session->drop(); });
}

/// What it is made of, with that one's sheen.
void WornPanel::choose(int make)
{
    const model::Worn* worn = chosen();
    if (worn == nullptr || make < 0 || worn->make == make)
        return;
    model::EditSession session;
    showEdit(session, worn->id, &model::WornSpec::lookStep, [make](model::Worn& one) {
        one.make = static_cast<std::uint8_t>(make);
        one.sheen = wornSpec(one.kind).makes[one.make].sheen;
    });
    session.commit();
}

void WornPanel::setPassable(bool passable)
{
    const model::Worn* worn = chosen();
    if (worn == nullptr || worn->passable == passable)
        return;
    model::EditSession session;
    showEdit(session, worn->id, &model::WornSpec::lookStep, [passable](model::Worn& one) { one.passable = passable; });
    session.commit();
}

void WornPanel::chooseColour()
{
    const model::Worn* worn = chosen();
    if (worn == nullptr)
        return;
    auto* dialog = new QColorDialog(QColor::fromRgb(worn->colour), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour of what is worn"));
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    const auto colour = [this, id = worn->id](const QColor& chosenColour) {
        showEdit(m_colourEdit, id, &model::WornSpec::lookStep,
                 [value = chosenColour.rgb()](model::Worn& one) { one.colour = value; });
    };
    connect(dialog, &QColorDialog::currentColorChanged, this, colour);
    connect(dialog, &QColorDialog::rejected, this, [this] { m_colourEdit.drop(); });
    connect(dialog, &QColorDialog::colorSelected, this, [this, colour](const QColor& selected) {
        colour(selected);
        m_colourEdit.commit();
    });
    dialog->open();
}

void WornPanel::followSwatches()
{
    m_ids.clear();
    const model::Worn* marked = chosen();
    for (const model::Worn& worn : m_state.document().project().worn) {
        const model::WornSpec& spec = wornSpec(worn.kind);
        if (!spec.drawn())
            continue;
        const std::size_t index = m_ids.size();
        m_ids.push_back(worn.id);
        if (index == m_swatches.size()) {
            auto* made = new Swatch(Qt::white, QString(), this);
            const int at = static_cast<int>(index);
            m_all->addWidget(made, at / kSwatchesARow, at % kSwatchesARow);
            connect(made, &Swatch::clicked, this, [this, index] {
                m_state.options().setChosenWorn(m_ids.at(index));
                follow(); // A click has unchecked the one that was chosen.
            });
            m_swatches.push_back(made);
        }
        Swatch& swatch = *m_swatches[index];
        const QString name = tr("%1 %2").arg(titleOf(worn)).arg(index + 1);
        swatch.setColour(QColor::fromRgb(worn.colour));
        swatch.setToolTip(name);
        swatch.setAccessibleName(name);
        swatch.setChecked(&worn == marked);
        swatch.show();
    }
    for (std::size_t index = m_ids.size(); index < m_swatches.size(); ++index)
        m_swatches[index]->hide();
}

void WornPanel::follow()
{
    followSwatches();
    setVisible(!m_ids.empty());
    const model::Worn* worn = chosen();
    const model::Id now = worn != nullptr ? worn->id : 0;
    if (std::exchange(m_shown, now) != now) {
        m_sheen->release();
        m_radius->release();
        m_tightness->release();
        m_coil->release();
    }
    m_look->setVisible(worn != nullptr);
    if (worn == nullptr)
        return;
    m_name->setText(titleOf(*worn));
    const model::WornSpec& spec = wornSpec(worn->kind);
    m_colour->setColour(QColor::fromRgb(worn->colour));
    m_sheen->setDefaultValue(static_cast<double>(spec.sheen) * kWornPercent);
    m_sheen->setValue(static_cast<double>(worn->sheen) * kWornPercent);
    const float smallest = spec.leastRadiusM;
    m_radius->setLabel(spec.sizeTitle != nullptr ? model::wornText(spec.sizeTitle) : tr("Radius"));
    m_radius->setRange(static_cast<double>(smallest) * kMmPerM, static_cast<double>(spec.greatestRadiusM) * kMmPerM, 1);
    m_radius->setDefaultValue(static_cast<double>(spec.radiusM * spec.proportions[spec.sizedAxis]) * kMmPerM);
    m_radius->setValue(static_cast<double>(worn->shape.semiAxesM[spec.sizedAxis]) * kMmPerM);
    followMaking(*worn);
}

void WornPanel::followMaking(const model::Worn& worn)
{
    const model::WornSpec& spec = wornSpec(worn.kind);
    m_make->setVisible(!spec.makes.empty());
    if (m_make->count() != static_cast<int>(spec.makes.size())) {
        m_make->clear();
        for (const model::WornMake& make : spec.makes)
            m_make->addItem(model::wornText(make.title));
    }
    m_make->setCurrentIndex(worn.make);
    m_tightness->setVisible(spec.tie.has_value());
    m_tightness->setValue(static_cast<double>(worn.tightness) * kWornPercent);
    m_passable->setVisible(spec.ownMesh);
    m_passable->setChecked(worn.passable);
    m_coil->setVisible(spec.coilRadiusM > 0.0F);
    m_coil->setDefaultValue(static_cast<double>(spec.coilRadiusM) * kMmPerM);
    m_coil->setValue(static_cast<double>(worn.coilRadiusM) * kMmPerM);
}

} // namespace hairpaint::view
