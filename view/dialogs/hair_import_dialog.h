// Asks for the unit and up axis of imported hair, to override those of the file or those that fit the head.
#pragma once

#include "model/importing/curve_fit.h"
#include "model/project/project.h"

#include <QDialog>

#include <cstddef>
#include <memory>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QLabel;

namespace hairpaint::view {

class HairOnHead;

/// What the dialog shows of a file's hair.
struct HairImportSample
{
    std::shared_ptr<const model::Head> head; ///< With a skin.
    model::ForeignCurves curves;             ///< Some hundred of them.
    std::size_t strands = 0;                 ///< Number of all that the file holds.
    /// By unit, then axis, in the order in which the dialog offers them, automatic first.
    std::vector<model::CurvePlacement> placements;

    /// Up to a second; any thread.
    [[nodiscard]] static HairImportSample of(const model::ForeignCurves& curves,
                                             const std::shared_ptr<const model::Head>& head);
};

/// Modal. When accepted, pass choice() to model::groupsFromCurves.
class HairImportDialog : public QDialog
{
    Q_OBJECT
public:
    HairImportDialog(HairImportSample sample, const QString& fileName, QWidget* parent = nullptr);
    /// Empty fields are left to the program.
    [[nodiscard]] model::CurveSpaceChoice choice() const;

private:
    void follow(); ///< Shows the hair in the unit and axis that are chosen.
    [[nodiscard]] QString remarkOn(const model::CurvePlacement& placement) const;

    HairImportSample m_sample;
    QComboBox* m_unit = nullptr;
    QComboBox* m_axis = nullptr;
    HairOnHead* m_preview = nullptr;
    QLabel* m_remarkIcon = nullptr;
    QLabel* m_remark = nullptr;
    QDialogButtonBox* m_buttons = nullptr;
};

} // namespace hairpaint::view
