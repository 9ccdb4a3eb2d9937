// Asks for the unit and up axis of imported hair, to override those of the file or those that fit the head.
#pragma once

#include "model/importing/curve_fit.h"

#include <QDialog>

class QComboBox;

namespace hairpaint::view {

/// Modal. When accepted, pass choice() to model::groupsFromCurves.
class HairImportDialog : public QDialog
{
    Q_OBJECT
public:
    explicit HairImportDialog(const QString& fileName, QWidget* parent = nullptr);
    /// Empty fields are left to the program.
    [[nodiscard]] model::CurveSpaceChoice choice() const;

private:
    QComboBox* m_unit = nullptr;
    QComboBox* m_axis = nullptr;
};

} // namespace hairpaint::view
