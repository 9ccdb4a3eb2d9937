// Handles as controls: see the header.
#include "view/panels/handle_panel.h"

#include "model/values/names.h"
#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>

namespace hairpaint::view {

using model::Change;
using model::HandleKind;
using model::HandleSpec;

namespace {

constexpr int kWidth = 216;

/// Whether a change may give a group other handles.
bool concerns(const Change& change)
{
    if (change.preview)
        return false;
    switch (change.aspect) {
    case Change::Aspect::Texels:
    case Change::Aspect::LayerList:
        return change.map == model::MapKind::Length || change.map == model::MapKind::Direction ||
               change.map == model::MapKind::Density;
    case Change::Aspect::Resolved:
    case Change::Aspect::Environment:
        return false;
    default:
        return true;
    }
}

} // namespace

HandlePanel::HandlePanel(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    setObjectName(QStringLiteral("handlePanel"));
    setAccessibleName(tr("Handles of this haircut"));
    setFixedWidth(kWidth);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kGap, metrics::kGrid, metrics::kGap, metrics::kGrid);
    column->setSpacing(metrics::kGrid);
    addSlider(HandleKind::Length, QStringLiteral("%"), 100.0, 0);
    addSlider(HandleKind::Fringe, QStringLiteral("%"), 100.0, 0);
    addSlider(HandleKind::Fade, tr("cm"), 100.0, 1);
    addPart();
    m_nothing = new QLabel(tr("This group has no hair yet: a style gives it some."), this);
    m_nothing->setWordWrap(true);
    m_nothing->setFont(themeFont(TextRole::Label));
    column->addWidget(m_nothing);
    column->addStretch(1);
    m_later.setSingleShot(true);
    m_later.setInterval(0);
    connect(&m_later, &QTimer::timeout, this, &HandlePanel::follow);
    const auto later = [this] { m_later.start(); };
    connect(&state.target(), &EditTarget::changed, this, later);
    connect(&state.document(), &model::Document::editEnded, this, later);
    connect(&state.document(), &model::Document::changed, this, [this](const Change& change) {
        if (change.aspect == Change::Aspect::Everything && !change.preview) {
            m_base.reset();
            m_known.forget();
        }
        if (concerns(change))
            m_later.start();
    });
    m_later.start();
}

void HandlePanel::addSlider(HandleKind kind, const QString& unit, double shownPerValue, int decimals)
{
    const HandleSpec& spec = model::handleSpec(kind);
    auto* slider = new BarSlider(spec.titleText(), this);
    slider->setRange(spec.least * shownPerValue, spec.greatest * shownPerValue, decimals);
    slider->setDefaultValue(spec.usual * shownPerValue);
    slider->setValue(spec.usual * shownPerValue);
    slider->setUnit(unit);
    slider->setHint(spec.hintText());
    connect(slider, &BarSlider::valueChanged, this,
            [this, kind, shownPerValue](double value) { show(kind, value / shownPerValue); });
    connect(slider, &BarSlider::editingFinished, this, &HandlePanel::commit);
    connect(slider, &BarSlider::editingCancelled, this, &HandlePanel::drop);
    m_sliders.at(static_cast<std::size_t>(kind)) = slider;
    layout()->addWidget(slider);
}

void HandlePanel::addPart()
{
    const HandleSpec& spec = model::handleSpec(HandleKind::Part);
    m_partRow = new QWidget(this);
    auto* row = new QHBoxLayout(m_partRow);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    auto* label = new QLabel(spec.titleText(), m_partRow);
    label->setFont(themeFont(TextRole::Label));
    m_part = new QComboBox(m_partRow);
    m_part->setObjectName(QStringLiteral("handlePart"));
    m_part->setAccessibleName(spec.titleText());
    m_part->setToolTip(spec.hintText());
    m_part->addItems({tr("As combed"), tr("Left"), tr("Middle"), tr("Right")}); // As model::PartSide.
    label->setBuddy(m_part);
    row->addWidget(label);
    row->addWidget(m_part, 1);
    layout()->addWidget(m_partRow);
    connect(m_part, &QComboBox::activated, this, [this](int index) {
        show(HandleKind::Part, index);
        commit();
    });
}

void HandlePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_later.start();
}

void HandlePanel::follow()
{
    // What is only looked at, and unfinished strokes, have handles when they are kept.
    if (!isVisible() || m_edit.active() || m_state.document().previewing())
        return;
    const model::Id group = m_state.target().group();
    if (m_state.document().committed().group(group) == nullptr)
        m_base.reset();
    else
        m_base = m_known.of(m_state.document(), group);
    bool hasAny = false;
    for (const HandleSpec& spec : model::handleSpecs()) {
        const bool has = m_base && m_base->handles->has(spec.kind);
        hasAny = hasAny || has;
        const double value = m_base ? m_base->values[spec.kind] : spec.usual;
        if (BarSlider* slider = m_sliders.at(static_cast<std::size_t>(spec.kind))) {
            slider->setVisible(has);
            slider->setValue(value * 100.0);
        } else {
            m_partRow->setVisible(has);
            m_part->setCurrentIndex(static_cast<int>(value));
        }
    }
    m_nothing->setVisible(!hasAny);
}

void HandlePanel::show(HandleKind kind, double value)
{
    if (!m_edit.active())
        m_state.document().endEdit(); // What somebody only looks at may have another group.
    if (!m_base || m_state.document().committed().group(m_base->group) == nullptr)
        return;
    m_edited = m_base;
    m_edited->values[kind] = value;
    m_edited->hair = m_edited->handles->at(m_edited->values);
    const model::HairGroup& group = *m_state.document().committed().group(m_base->group);
    const QString text =
        QCoreApplication::translate("HairHandles", model::handleSpec(kind).step).arg(model::shownName(group.name));
    m_state.document().show(m_edit, {.text = text}, {.aspect = Change::Aspect::GroupList, .group = group.id},
                            [id = group.id, hair = m_edited->hair](model::Project& project) {
                                if (model::HairGroup* one = project.group(id))
                                    hair.applyTo(*one);
                            });
}

void HandlePanel::commit()
{
    if (m_edit.active() && m_edited)
        m_known.add(*m_edited);
    m_edited.reset();
    m_edit.commit();
    m_later.start();
}

void HandlePanel::drop()
{
    m_edited.reset();
    m_edit.drop();
    m_later.start();
}

} // namespace hairpaint::view
