// Asks how a picture of the 3D area is saved, with a preview.
#pragma once

#include <QColor>
#include <QDialog>
#include <QImage>
#include <QSize>
#include <QTimer>

#include <cstdint>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLayout;
class QSpinBox;

namespace hairpaint::view {

class Swatch;

/// What lies behind the head.
enum class PictureBackground : std::uint8_t
{
    Shown, ///< As in the 3D area.
    Transparent,
    Colour
};

enum class PictureFraming : std::uint8_t
{
    Shown, ///< All that the 3D area shows; the picture may show more at its sides.
    Hair,  ///< Head and hair with a margin, from the same side.
    Head,
    Bust ///< The whole mesh.
};

struct PictureChoice
{
    static constexpr int kLeastPx = 16; ///< A side.
    static constexpr int kMostPx = 8192;
    static constexpr int kMostFinePx = 4096; ///< Larger pictures have one sample a pixel.

    bool isAsView = false;  ///< As many pixels as the 3D area has; else `size`.
    QSize size{2048, 2048}; ///< px
    bool keepsShape = true; ///< Width and height change together.
    PictureFraming framing = PictureFraming::Shown;
    PictureBackground background = PictureBackground::Shown;
    QColor colour{255, 255, 255};
    int samples = 4; ///< A pixel: 1, 4 or 16.
    friend bool operator==(const PictureChoice&, const PictureChoice&) = default;
};

/// Not modal. Nothing is drawn or saved by it: previewWanted is answered with showPreview(), the next one is asked for
/// only then. Enter in a field is Save, Esc leaves.
class PictureDialog : public QDialog
{
    Q_OBJECT
public:
    /// `viewPx`: size of the 3D area.
    PictureDialog(const PictureChoice& before, QSize viewPx, QWidget* parent = nullptr);
    ~PictureDialog() override;
    [[nodiscard]] PictureChoice choice() const;
    [[nodiscard]] QSize picturePx() const;
    [[nodiscard]] QSize previewPx() const; ///< The picture's shape in the room that the dialog has.
    void setViewPx(QSize px);
    /// The preview is out of date.
    void refresh();
    void showPreview(const QImage& picture); ///< Null: it could not be drawn.

Q_SIGNALS:
    void previewWanted();
    void saveWanted();

protected:
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QLayout* buildForm();
    [[nodiscard]] QLayout* buildSide();
    void addSizeRows(QFormLayout& form);
    void addBackgroundRow(QFormLayout& form);
    [[nodiscard]] QComboBox* addChoice(QFormLayout& form, const QString& label, const QStringList& texts);
    void fill(const PictureChoice& choice);
    void chooseSize(); ///< Takes the size chosen in the list.
    void changeSide(QSpinBox& side, bool isWidth);
    void chooseColour();
    void showSize(QSize px);
    void follow();

    QSize m_viewPx;
    double m_widthPerHeight = 1.0; ///< Kept while the proportions are locked.
    QComboBox* m_sizes = nullptr;
    QSpinBox* m_width = nullptr;
    QSpinBox* m_height = nullptr;
    QCheckBox* m_keepsShape = nullptr;
    QComboBox* m_framing = nullptr;
    QComboBox* m_background = nullptr;
    Swatch* m_colour = nullptr;
    QComboBox* m_samples = nullptr;
    QLabel* m_note = nullptr;
    QLabel* m_preview = nullptr;
    QTimer m_soon;          ///< Until the next small picture is asked for.
    bool m_isAsked = false; ///< A small picture is being drawn.
    bool m_isStale = false; ///< That picture shows an earlier state.
};

} // namespace hairpaint::view
