// One style of the strip: its picture and name.
#pragma once

#include <QAbstractButton>
#include <QImage>

namespace hairpaint::view {

class StyleTile : public QAbstractButton
{
    Q_OBJECT
public:
    /// `path` empty: the tile that saves a style.
    StyleTile(const QString& path, const QString& name, bool own, QWidget* parent = nullptr);
    [[nodiscard]] const QString& path() const { return m_path; }
    [[nodiscard]] bool own() const { return m_own; }
    void setPicture(const QImage& picture);
    [[nodiscard]] bool hasPicture() const { return !m_picture.isNull(); }
    void setBusy(bool busy);
    static constexpr int kPicture = 96;
    [[nodiscard]] QSize sizeHint() const override { return {kPicture + 4, kPicture + 24}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void entered();
    void left();

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString m_path;
    bool m_own;
    bool m_busy = false;
    QImage m_picture;
};

} // namespace hairpaint::view
