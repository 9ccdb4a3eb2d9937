// Shows where an imported head's landmarks were found, beside those of the display bust, and lets them be moved.
#pragma once

#include "model/project/project.h"

#include <QDialog>

#include <memory>

class QHBoxLayout;
class QLayout;
class QPushButton;

namespace hairpaint::view {

class HeadSide;

/// Modal.
class LandmarksDialog : public QDialog
{
    Q_OBJECT
public:
    /// The head has a skin. Where its landmarks are not known, points near those of the display bust are offered.
    explicit LandmarksDialog(const std::shared_ptr<const model::Head>& head, QWidget* parent = nullptr);
    [[nodiscard]] const sim::HeadLandmarks& landmarks() const;

private:
    [[nodiscard]] QLayout* buildSides();
    [[nodiscard]] QLayout* buildColumn(const QString& title, HeadSide* side);

    HeadSide* m_known;
    HeadSide* m_moved;
    QPushButton* m_reset = nullptr;
};

} // namespace hairpaint::view
