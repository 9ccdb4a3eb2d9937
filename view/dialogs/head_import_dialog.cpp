// Unit and axis of an imported mesh.
#include "view/dialogs/head_import_dialog.h"

#include "model/files/head_file.h"
#include "view/dialogs/length_units.h"
#include "view/dialogs/mesh_silhouette.h"
#include "view/look/icons.h"
#include "view/look/theme.h"
#include "view/widgets/bar_slider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace hairpaint::view {

namespace {

constexpr double kCm = 100.0;
/// Heads, busts and whole bodies lie between these; anything else is most likely a wrong unit.
constexpr double kShortestCm = 12.0;
constexpr double kTallestCm = 230.0;

} // namespace

QString HeadImportDialog::refusal(const sim::HeadMesh& source, const QString& fileName)
{
    if (source.triangles.empty() || source.positionsHd.empty())
        return tr("“%1” holds no triangles. Export the head as a mesh and try again.").arg(fileName);
    bool spread = false;
    for (const glm::vec2& uv : source.uvs)
        spread = spread || uv != source.uvs.front();
    if (source.uvs.size() != source.positionsHd.size() || !spread)
        return tr("“%1” has no UV layout, and without one there is nothing to paint on. Unwrap the head in your 3D "
                  "program and export it with its UVs.")
            .arg(fileName);
    return {};
}

HeadImportDialog::HeadImportDialog(model::RiggedMesh source, const QString& fileName, QWidget* parent)
    : QDialog(parent), m_source(std::move(source)), m_refusal(refusal(m_source, fileName))
{
    setWindowTitle(tr("Import head"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(metrics::kPadding);
    layout->addStrut(428); // A minimum width of the dialog would let it be narrower than its words.
    auto* title = new QLabel(fileName, this);
    title->setProperty("role", QStringLiteral("title"));
    title->setTextFormat(Qt::PlainText);
    title->setWordWrap(true);
    layout->addWidget(title);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    m_silhouette = new MeshSilhouette(m_source, this);
    row->addWidget(m_silhouette, 0, Qt::AlignTop);
    row->addLayout(buildForm(), 1);
    layout->addLayout(row);
    layout->addLayout(buildRemark());
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("Import"));
    m_buttons->button(QDialogButtonBox::Cancel)->setText(m_refusal.isEmpty() ? tr("Cancel") : tr("Close"));
    layout->addWidget(m_buttons);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    guess();
    follow();
}

QFormLayout* HeadImportDialog::buildForm()
{
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_unit = new QComboBox(this);
    for (const LengthUnit& unit : kLengthUnits)
        m_unit->addItem(titleOf(unit), unit.metres);
    m_unit->addItem(tr("By height"), 0.0);
    m_axis = new QComboBox(this);
    for (const model::UpAxis axis : {model::UpAxis::Y, model::UpAxis::Z})
        m_axis->addItem(titleOf(axis), static_cast<int>(axis));
    m_height = new BarSlider(tr("Height"), this);
    m_height->setRange(1.0, 300.0, 1);
    m_height->setExponent(2.0);
    m_height->setUnit(tr("cm"));
    form->addRow(tr("One &unit is"), m_unit);
    form->addRow(tr("&Up is"), m_axis);
    m_carry = new QCheckBox(tr("&Carry the hairstyle over"), this);
    m_carry->setToolTip(tr("Hairline, parting and every painted map go to the same places of the new head. Otherwise "
                           "the maps stay as they are, for a head with the same layout."));
    m_carry->setChecked(true);
    form->addRow(m_height);
    form->addRow(m_carry);
    connect(m_unit, &QComboBox::currentIndexChanged, this, &HeadImportDialog::follow);
    connect(m_axis, &QComboBox::currentIndexChanged, this, &HeadImportDialog::follow);
    connect(m_height, &BarSlider::editingBegan, this, [this] { m_before = {m_unit->currentIndex(), m_ownScale}; });
    connect(m_height, &BarSlider::editingCancelled, this, [this] {
        m_ownScale = m_before.second;
        m_unit->setCurrentIndex(m_before.first);
        follow();
    });
    connect(m_height, &BarSlider::valueChanged, this, [this](double cm) {
        const double source = sourceHeight();
        if (source <= 0.0)
            return;
        m_ownScale = cm / kCm / source;
        m_unit->setCurrentIndex(m_unit->count() - 1);
        follow();
    });
    return form;
}

QHBoxLayout* HeadImportDialog::buildRemark()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    m_remarkIcon = new QLabel(this);
    m_remarkIcon->setPixmap(iconPixmap(QStringLiteral("error"), 20, Theme::current().error, devicePixelRatioF()));
    m_remark = new QLabel(this);
    m_remark->setTextFormat(Qt::PlainText);
    m_remark->setWordWrap(true);
    row->addWidget(m_remarkIcon, 0, Qt::AlignTop);
    row->addWidget(m_remark, 1);
    return row;
}

void HeadImportDialog::guess()
{
    if (!m_refusal.isEmpty())
        return;
    const model::HeadGuess likely = model::guessHead(m_source);
    m_axis->setCurrentIndex(m_axis->findData(static_cast<int>(likely.upAxis)));
    m_ownScale = static_cast<double>(likely.unitScale);
    int index = m_unit->count() - 1;
    for (std::size_t i = 0; i < kLengthUnits.size(); ++i)
        if (std::abs(kLengthUnits.at(i).metres - m_ownScale) < m_ownScale * 1e-3)
            index = static_cast<int>(i);
    m_unit->setCurrentIndex(index);
}

double HeadImportDialog::sourceHeight() const
{
    if (m_source.positionsHd.empty())
        return 0.0;
    const auto up = [this](const glm::vec3& position) {
        return upAxis() == model::UpAxis::Y ? position.y : position.z;
    };
    const auto [low, high] = std::ranges::minmax(m_source.positionsHd, {}, up);
    return static_cast<double>(up(high) - up(low));
}

float HeadImportDialog::unitScale() const
{
    const double metres = m_unit->currentData().toDouble();
    return static_cast<float>(metres > 0.0 ? metres : m_ownScale);
}

model::UpAxis HeadImportDialog::upAxis() const
{
    return static_cast<model::UpAxis>(m_axis->currentData().toInt());
}

bool HeadImportDialog::carriesHair() const
{
    return m_carry->isChecked();
}

double HeadImportDialog::heightCm() const
{
    return sourceHeight() * static_cast<double>(unitScale()) * kCm;
}

bool HeadImportDialog::isAsTold() const
{
    if (m_source.told.up == model::ToldAxis::None || !(m_source.told.metresPerUnit > 0.0F))
        return false;
    const model::HeadGuess told = model::guessHead(m_source);
    return told.upAxis == upAxis() && std::abs(told.unitScale - unitScale()) < 1e-3F * told.unitScale;
}

void HeadImportDialog::follow()
{
    const bool usable = m_refusal.isEmpty();
    m_unit->setEnabled(usable);
    m_axis->setEnabled(usable);
    m_height->setEnabled(usable);
    m_carry->setEnabled(usable);
    m_silhouette->setUpAxis(upAxis());
    m_silhouette->setMetresPerUnit(usable ? static_cast<double>(unitScale()) : 0.0);
    if (m_unit->currentData().toDouble() > 0.0)
        m_ownScale = m_unit->currentData().toDouble();
    const double height = heightCm();
    m_height->setValue(height);
    const bool odd = height < kShortestCm || height > kTallestCm;
    const int faces = static_cast<int>(m_source.triangles.size());
    if (!usable)
        m_remark->setText(m_refusal);
    else if (odd)
        m_remark->setText(tr("%Ln triangles. %1 cm is no usual height for a head, a bust or a body: check the unit "
                             "and the axis.",
                             nullptr, faces)
                              .arg(QLocale().toString(height, 'f', 1)));
    else if (isAsTold())
        m_remark->setText(tr("%Ln triangles, %1 cm tall; unit and axis are those that the file tells.", nullptr, faces)
                              .arg(QLocale().toString(height, 'f', 1)));
    else
        m_remark->setText(tr("%Ln triangles, %1 cm tall.", nullptr, faces).arg(QLocale().toString(height, 'f', 1)));
    m_remarkIcon->setVisible(!usable || odd);
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(usable && height > 0.0);
}

} // namespace hairpaint::view
