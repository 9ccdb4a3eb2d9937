// Unit and axis of imported hair.
#include "view/dialogs/hair_import_dialog.h"

#include "view/dialogs/hair_on_head.h"
#include "view/dialogs/length_units.h"
#include "view/look/icons.h"
#include "view/look/theme.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace hairpaint::view {

namespace {

constexpr std::array<std::optional<model::UpAxis>, 3> kAxes{std::nullopt, model::UpAxis::Y, model::UpAxis::Z};

/// The unit that a transform turns to metres; none where it was fitted.
const LengthUnit* unitOf(const model::CurveTransform& transform)
{
    if (transform.offsetHd != glm::vec3(0.0F))
        return nullptr;
    const auto* found = std::ranges::find_if(
        kLengthUnits, [&](const LengthUnit& unit) { return static_cast<float>(unit.metres) == transform.scaleM; });
    return found == kLengthUnits.end() ? nullptr : found;
}

} // namespace

HairImportSample HairImportSample::of(const model::ForeignCurves& curves,
                                      const std::shared_ptr<const model::Head>& head)
{
    HairImportSample sample;
    sample.head = head;
    sample.curves = model::sampledCurves(curves);
    for (const model::ForeignStrands& group : curves.groups)
        sample.strands += group.count();
    const auto add = [&](std::optional<float> metres) {
        for (const std::optional<model::UpAxis> axis : kAxes)
            sample.placements.push_back(
                model::placementOf(sample.curves, {.metresPerUnit = metres, .upAxis = axis}, *head->skin));
    };
    add(std::nullopt);
    for (const LengthUnit& unit : kLengthUnits)
        add(static_cast<float>(unit.metres));
    return sample;
}

HairImportDialog::HairImportDialog(HairImportSample sample, const QString& fileName, QWidget* parent)
    : QDialog(parent), m_sample(std::move(sample))
{
    setWindowTitle(tr("Import hair"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(metrics::kPadding);
    auto* title = new QLabel(fileName, this);
    title->setProperty("role", QStringLiteral("title"));
    title->setTextFormat(Qt::PlainText);
    title->setWordWrap(true);
    layout->addWidget(title);
    m_preview = new HairOnHead(m_sample.head->skin->mesh(), m_sample.curves, this);
    layout->addWidget(m_preview);
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_unit = new QComboBox(this);
    m_unit->addItem(tr("Automatic"), 0.0);
    for (const LengthUnit& unit : kLengthUnits)
        m_unit->addItem(titleOf(unit), unit.metres);
    m_axis = new QComboBox(this);
    for (const std::optional<model::UpAxis> axis : kAxes)
        m_axis->addItem(axis ? titleOf(*axis) : tr("Automatic"));
    form->addRow(tr("One &unit is"), m_unit);
    form->addRow(tr("&Up is"), m_axis);
    layout->addLayout(form);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    m_remarkIcon = new QLabel(this);
    m_remarkIcon->setPixmap(iconPixmap(QStringLiteral("error"), 20, Theme::current().error, devicePixelRatioF()));
    m_remark = new QLabel(this);
    m_remark->setWordWrap(true);
    row->addWidget(m_remarkIcon, 0, Qt::AlignTop);
    row->addWidget(m_remark, 1);
    layout->addLayout(row);
    auto* outcome = new QLabel(tr("The hair becomes a new group, with maps to paint on."), this);
    outcome->setWordWrap(true);
    layout->addWidget(outcome);
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Import"));
    m_buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    layout->addWidget(m_buttons);
    setMinimumWidth(380);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &HairImportDialog::follow);
    connect(m_axis, &QComboBox::currentIndexChanged, this, &HairImportDialog::follow);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    follow();
}

void HairImportDialog::follow()
{
    const auto index = static_cast<std::size_t>(m_unit->currentIndex()) * kAxes.size() +
                       static_cast<std::size_t>(m_axis->currentIndex());
    const model::CurvePlacement& placement = m_sample.placements.at(index);
    m_preview->setTransform(placement.transform);
    m_remark->setText(remarkOn(placement));
    m_remarkIcon->setVisible(!placement.fits);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(placement.fits);
}

QString HairImportDialog::remarkOn(const model::CurvePlacement& placement) const
{
    const int strands = static_cast<int>(m_sample.strands);
    if (!placement.fits) {
        constexpr float kCm = 100.0F;
        return tr("%Ln strands. In this unit and axis most roots are %1 cm off the skin or further, so they can't come "
                  "in: choose another, or Automatic, or export them as they stand on a head.",
                  nullptr, strands)
            .arg(QLocale().toString(placement.rootsOffM * kCm, 'f', 1));
    }
    const LengthUnit* unit = unitOf(placement.transform);
    if (unit == nullptr)
        return tr("%Ln strands, turned, scaled and moved until their roots lay on the head.", nullptr, strands);
    const model::UpAxis axis = placement.transform.rotation == glm::mat3(1.0F) ? model::UpAxis::Y : model::UpAxis::Z;
    return tr("%Ln strands, their roots on the head. Unit: %1; up: %2.", nullptr, strands)
        .arg(titleOf(*unit), titleOf(axis));
}

model::CurveSpaceChoice HairImportDialog::choice() const
{
    model::CurveSpaceChoice choice{.metresPerUnit = std::nullopt,
                                   .upAxis = kAxes.at(static_cast<std::size_t>(m_axis->currentIndex()))};
    if (const double metres = m_unit->currentData().toDouble(); metres > 0.0)
        choice.metresPerUnit = static_cast<float>(metres);
    return choice;
}

} // namespace hairpaint::view
