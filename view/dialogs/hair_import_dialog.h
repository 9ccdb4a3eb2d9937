// Asks what unit and which axis imported hair has, where what the file says, or what fits the head, is not to count.
#pragma once

#include "model/importing/curve_placing.h"

#include <QDialog>

class QComboBox;

namespace hairpaint::view {

/// Modal. When accepted, pass choice() to model::groupsFromCurves.
class HairImportDialog : public QDialog
{
    Q_OBJECT
public:
    explicit HairImportDialog(const QString& fileName, QWidget* parent = nullptr);
    /// Empty in what is left to the program.
    [[nodiscard]] model::CurveSpaceChoice choice() const;

private:
    QComboBox* m_unit = nullptr;
    QComboBox* m_axis = nullptr;
};

} // namespace hairpaint::view
