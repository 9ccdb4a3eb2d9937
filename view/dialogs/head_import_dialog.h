// Asks what unit and which axis an imported mesh has, with a guess and the height that follows from it.
#pragma once

#include "model/heads/rigged_mesh.h"
#include "model/project/project.h"

#include <QDialog>

#include <utility>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QTableWidget;
class QVBoxLayout;

namespace hairpaint::view {

class BarSlider;
class MeshSilhouette;

/// Modal. When accepted, pass unitScale() and upAxis() to model::makeHead. A character of several parts has a list of
/// them, with what becomes of each.
class HeadImportDialog : public QDialog
{
    Q_OBJECT
public:
    HeadImportDialog(model::RiggedMesh source, const QString& fileName, QWidget* parent = nullptr);
    [[nodiscard]] float unitScale() const;
    [[nodiscard]] model::UpAxis upAxis() const;
    /// The file's space, an axis: where the face looks.
    [[nodiscard]] glm::ivec3 facing() const;
    /// The mesh, with what becomes of its parts.
    [[nodiscard]] const model::RiggedMesh& source() const { return m_source; }
    /// Whether a uv layout is to be made instead of the file's.
    [[nodiscard]] bool makesLayout() const;
    /// Whether the hairstyle is to be carried to it; else its maps stay as they lie.
    [[nodiscard]] bool carriesHair() const;
    /// Height along the chosen axis at the chosen scale, cm.
    [[nodiscard]] double heightCm() const;

    /// Why the mesh can't be a head (no uv layout, no triangles); empty where it can.
    [[nodiscard]] static QString refusal(const sim::HeadMesh& source, const QString& fileName);

private:
    [[nodiscard]] QFormLayout* buildForm();
    [[nodiscard]] QHBoxLayout* buildRemark();
    void buildParts(QVBoxLayout* layout);
    void followParts(); ///< What is ticked.
    [[nodiscard]] bool growsSomewhere() const;
    void guess();
    [[nodiscard]] double sourceHeight() const; ///< Along the chosen axis, in the source's units.
    /// Whether unit and axis are what the file itself tells.
    [[nodiscard]] bool isAsTold() const;
    void follow();

    model::RiggedMesh m_source;
    QString m_refusal;
    QComboBox* m_unit = nullptr;
    QComboBox* m_axis = nullptr;
    BarSlider* m_height = nullptr;
    QComboBox* m_facing = nullptr;
    QTableWidget* m_parts = nullptr; ///< Null where there is but one.
    QCheckBox* m_ownLayout = nullptr;
    QCheckBox* m_carry = nullptr;
    QLabel* m_remark = nullptr;
    QLabel* m_remarkIcon = nullptr;
    MeshSilhouette* m_silhouette = nullptr;
    QDialogButtonBox* m_buttons = nullptr;
    double m_ownScale = 0.0;         ///< Metres per unit, when the height was set by hand.
    std::pair<int, double> m_before; ///< Unit and scale before the height is set by hand.
};

} // namespace hairpaint::view
