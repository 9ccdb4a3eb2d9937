// Unit and axis of an imported mesh.
#include "view/dialogs/head_import_dialog.h"

#include "model/files/head_file.h"
#include "model/files/part_selection.h"
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
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
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
    if (m_source.parts.size() > 1)
        buildParts(layout);
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
    m_facing = new QComboBox(this);
    for (const QString& side : {tr("To the front"), tr("To the left"), tr("To the back"), tr("To the right")})
        m_facing->addItem(side, m_facing->count()); // Quarter turns.
    form->addRow(tr("The &face looks"), m_facing);
    m_carry = new QCheckBox(tr("&Carry the hairstyle over"), this);
    m_carry->setToolTip(tr("Hairline, parting and every painted map go to the same places of the new head. Otherwise "
                           "the maps stay as they are, for a head with the same layout."));
    m_carry->setChecked(true);
    m_ownLayout = new QCheckBox(tr("&Make a layout of our own"), this);
    m_ownLayout->setToolTip(
        tr("Another UV layout, in which no two places of the skin share a texel. For heads without a "
           "layout, or whose left and right half lie over each other in it."));
    form->addRow(m_height);
    form->addRow(m_carry);
    form->addRow(m_ownLayout);
    connect(m_ownLayout, &QCheckBox::toggled, this, &HeadImportDialog::follow);
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

void HeadImportDialog::buildParts(QVBoxLayout* layout)
{
    constexpr int kShownRows = 6;
    m_parts = new QTableWidget(static_cast<int>(m_source.parts.size()), 3, this);
    m_parts->setAccessibleName(tr("Parts of the character"));
    m_parts->setHorizontalHeaderLabels({tr("Part"), tr("Comes in"), tr("Hair grows")});
    m_parts->verticalHeader()->hide();
    m_parts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (const int column : {1, 2})
        m_parts->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_parts->setSelectionMode(QAbstractItemView::NoSelection);
    m_parts->setEditTriggers(QAbstractItemView::NoEditTriggers);
    for (int row = 0; row < m_parts->rowCount(); ++row) {
        const auto part = static_cast<std::size_t>(row);
        auto* name = new QTableWidgetItem(model::titleOf(m_source, part));
        name->setFlags(Qt::ItemIsEnabled);
        if (!m_source.parts[part].hasLayout)
            name->setToolTip(tr("It has no UV coordinates."));
        m_parts->setItem(row, 0, name);
        for (const int column : {1, 2}) {
            auto* tick = new QTableWidgetItem;
            tick->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
            tick->setCheckState(Qt::Unchecked);
            m_parts->setItem(row, column, tick);
        }
    }
    const int rows = std::min(m_parts->rowCount(), kShownRows);
    m_parts->setFixedHeight(m_parts->horizontalHeader()->sizeHint().height() + rows * m_parts->rowHeight(0) + 2);
    layout->addWidget(m_parts);
    connect(m_parts, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* changed) {
        const QSignalBlocker quiet(m_parts);
        // Hair grows on what is there alone.
        if (changed->column() == 2 && changed->checkState() == Qt::Checked)
            m_parts->item(changed->row(), 1)->setCheckState(Qt::Checked);
        if (changed->column() == 1 && changed->checkState() == Qt::Unchecked)
            m_parts->item(changed->row(), 2)->setCheckState(Qt::Unchecked);
        followParts();
    });
}

void HeadImportDialog::followParts()
{
    for (int row = 0; row < m_parts->rowCount(); ++row) {
        const bool grows = m_parts->item(row, 2)->checkState() == Qt::Checked;
        const bool comesIn = m_parts->item(row, 1)->checkState() == Qt::Checked;
        m_source.parts[static_cast<std::size_t>(row)].use = grows     ? model::PartUse::Grows
                                                            : comesIn ? model::PartUse::Seen
                                                                      : model::PartUse::LeftOut;
    }
    follow();
}

bool HeadImportDialog::growsSomewhere() const
{
    return m_source.parts.empty() || std::ranges::any_of(m_source.parts, [this](const model::MeshPart& part) {
               return part.use == model::PartUse::Grows && (part.hasLayout || makesLayout());
           });
}

bool HeadImportDialog::makesLayout() const
{
    return m_ownLayout->isChecked();
}

glm::ivec3 HeadImportDialog::facing() const
{
    // From the front to the left as the figure has it, to the back, to the right.
    const glm::ivec3 front = upAxis() == model::UpAxis::Y ? glm::ivec3(0, 0, 1) : glm::ivec3(0, -1, 0);
    const std::array sides{front, glm::ivec3(1, 0, 0), -front, glm::ivec3(-1, 0, 0)};
    return sides.at(static_cast<std::size_t>(std::max(m_facing->currentIndex(), 0)));
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
    // Names are not asked for, so none can be wrong.
    if (m_parts == nullptr || !model::choosePartsBy(m_source, {}, likely))
        return;
    const QSignalBlocker quiet(m_parts);
    for (int row = 0; row < m_parts->rowCount(); ++row) {
        const model::PartUse use = m_source.parts[static_cast<std::size_t>(row)].use;
        m_parts->item(row, 1)->setCheckState(use == model::PartUse::LeftOut ? Qt::Unchecked : Qt::Checked);
        m_parts->item(row, 2)->setCheckState(use == model::PartUse::Grows ? Qt::Checked : Qt::Unchecked);
    }
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
    m_facing->setEnabled(usable);
    m_ownLayout->setEnabled(usable);
    if (m_parts != nullptr)
        m_parts->setEnabled(usable);
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
    else if (!growsSomewhere())
        m_remark->setText(tr("Tick a part that hair is to grow on; one without UV coordinates needs a layout of our "
                             "own."));
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
    m_remarkIcon->setVisible(!usable || odd || !growsSomewhere());
    m_buttons->button(QDialogButtonBox::Ok)->setEnabled(usable && height > 0.0 && growsSomewhere());
}

} // namespace hairpaint::view
