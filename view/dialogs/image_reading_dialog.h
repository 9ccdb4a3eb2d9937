// Asks whether an image tells a map by its colours or by its brightness, where its pixels allow both.
#pragma once

#include <QDialog>
#include <QImage>

class QRadioButton;

namespace hairpaint::view {

/// Both, as the map would look.
struct ReadingPreview
{
    QImage asScale;
    QImage asValue;
};

/// Modal.
class ImageReadingDialog : public QDialog
{
    Q_OBJECT
public:
    ImageReadingDialog(const QString& imageName, const QString& mapTitle, const ReadingPreview& preview,
                       QWidget* parent = nullptr);
    /// Brightness is the value.
    [[nodiscard]] bool isValue() const;

private:
    QRadioButton* m_value = nullptr;
};

} // namespace hairpaint::view
