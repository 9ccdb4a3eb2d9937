// Asks which hair is exported, in which format, and for which program.
#pragma once

#include "model/formats/export_format.h"

#include <QDialog>
#include <QSet>

#include <cstdint>
#include <memory>
#include <vector>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QScrollArea;

namespace hairpaint::view {

class BarSlider;
class ExportOptionFields;

/// Which hair is exported.
enum class HairSource : std::uint8_t
{
    Now,     ///< As the 3D area shows it.
    Settled, ///< After it has fallen for two seconds.
    Rest     ///< As it is combed, before it falls.
};

/// A visible hair group, and how many hairs it has to export.
struct ExportableGroup
{
    int id = 0;
    QString name;
    std::size_t hairs = 0;
    friend bool operator==(const ExportableGroup&, const ExportableGroup&) = default;
};

struct HairExportChoice
{
    /// Without the part that comes from the project.
    model::ExportRequest request{.format = &model::exportFormats().front(), .target = &model::exportTargets().front()};
    HairSource source = HairSource::Now;
};

/// Not modal: it stays open beside the cards that it has shown. Nothing is exported by it: whoever hears its signals
/// asks for choice(), and closes it when the file is there.
class ExportHairDialog : public QDialog
{
    Q_OBJECT
public:
    /// Begins with format, target, source and options of the choice before, and with all groups and all hairs.
    ExportHairDialog(std::vector<ExportableGroup> groups, const HairExportChoice& before, QWidget* parent = nullptr);
    ~ExportHairDialog() override;
    [[nodiscard]] HairExportChoice choice() const;
    /// Why there can be no avatar of this head, a sentence; empty where there can.
    void setAvatarProblem(const QString& problem);
    /// The groups that can be exported now. Groups that were unchecked stay so.
    void setGroups(std::vector<ExportableGroup> groups);

Q_SIGNALS:
    void exportWanted();
    void previewWanted(); ///< The cards are to be shown in the 3D area.

private:
    [[nodiscard]] QFormLayout* buildForm();
    void listGroups();
    [[nodiscard]] QComboBox* addChoice(QFormLayout& form, const QString& label);
    void fill(const HairExportChoice& before);
    [[nodiscard]] bool isLeftOut(const ExportableGroup& group) const;
    [[nodiscard]] std::size_t hairsOfChosen() const;
    void follow();

    std::vector<ExportableGroup> m_groups;
    std::vector<QCheckBox*> m_boxes; ///< [groups]; visible where there are several.
    QSet<int> m_leftOut;             ///< Ids of groups that are not exported.
    QScrollArea* m_list = nullptr;   ///< The list of the boxes.
    QFormLayout* m_form = nullptr;
    QComboBox* m_format = nullptr;
    QComboBox* m_target = nullptr;
    QComboBox* m_source = nullptr;
    BarSlider* m_hairs = nullptr;
    std::unique_ptr<ExportOptionFields> m_options;
    QString m_avatarProblem;
    QLabel* m_use = nullptr;
    QDialogButtonBox* m_buttons = nullptr;
    QPushButton* m_preview = nullptr; ///< Asks for a preview of the cards.
};

} // namespace hairpaint::view
