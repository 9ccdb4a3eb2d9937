// A sentence close to a field: why what was typed is not taken, or what became of it.
#pragma once

#include <QLabel>

namespace hairpaint::view {

/// Over everything, under the field or above it where there is no room; one a field. It goes when the user presses a
/// key or a button, or leaves the window. Screen readers hear of it.
class FieldHint : public QLabel
{
    Q_OBJECT
public:
    enum class Tone
    {
        Note,   ///< What became of it.
        Problem ///< Why it is not taken.
    };
    static void showAt(QWidget& field, const QString& sentence, Tone tone);
    static void hideAt(const QWidget& field);
    /// What the field's hint says; empty where none is shown.
    [[nodiscard]] static QString textAt(const QWidget& field);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    explicit FieldHint(QWidget& field);
    void reposition();
    [[nodiscard]] static FieldHint* of(const QWidget& field);
};

/// A line edit's content as refused, in the colour of errors, or as fine.
void markRefused(QWidget& edit, bool refused);

} // namespace hairpaint::view
