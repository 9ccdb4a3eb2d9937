// Reads widgets: see the header.
#include "tests/support/seen_text.h"

#include "view/widgets/bar_slider.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QCoreApplication>
#include <QGroupBox>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPointer>
#include <QTabBar>
#include <QTextDocumentFragment>
#include <QTextEdit>
#include <QToolTip>

namespace hairpaint::test {

namespace {

/// Draws nothing and remembers each text.
class TextEngine : public QPaintEngine
{
public:
    TextEngine() : QPaintEngine(QPaintEngine::AllFeatures) {}
    bool begin(QPaintDevice* /*device*/) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState& /*state*/) override {}
    void drawPixmap(const QRectF& /*to*/, const QPixmap& /*pixmap*/, const QRectF& /*from*/) override {}
    void drawImage(const QRectF& /*to*/, const QImage& /*image*/, const QRectF& /*from*/,
                   Qt::ImageConversionFlags /*flags*/) override
    {}
    void drawTiledPixmap(const QRectF& /*to*/, const QPixmap& /*pixmap*/, const QPointF& /*from*/) override {}
    void drawPath(const QPainterPath& /*path*/) override {}
    void drawPolygon(const QPointF* /*points*/, int /*count*/, PolygonDrawMode /*mode*/) override {}
    void drawPolygon(const QPoint* /*points*/, int /*count*/, PolygonDrawMode /*mode*/) override {}
    void drawTextItem(const QPointF& /*position*/, const QTextItem& item) override { texts.append(item.text()); }
    [[nodiscard]] Type type() const override { return User; }

    QStringList texts;
};

class TextDevice : public QPaintDevice
{
public:
    explicit TextDevice(QSize size) : m_size(size) {}
    [[nodiscard]] QPaintEngine* paintEngine() const override { return &m_engine; }
    [[nodiscard]] const QStringList& texts() const { return m_engine.texts; }

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override
    {
        constexpr int kDotsPerInch = 96;
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmWidthMM:
            return m_size.width() * 254 / (kDotsPerInch * 10);
        case PdmHeightMM:
            return m_size.height() * 254 / (kDotsPerInch * 10);
        case PdmNumColors:
            return INT_MAX;
        case PdmDepth:
            return 32;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return kDotsPerInch;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        }
        return 0;
    }

private:
    QSize m_size;
    mutable TextEngine m_engine;
};

void addModel(QStringList& texts, const QAbstractItemModel& model, const QModelIndex& parent)
{
    for (int row = 0; row < model.rowCount(parent); ++row)
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex index = model.index(row, column, parent);
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole})
                texts.append(index.data(role).toString());
            addModel(texts, model, index);
        }
}

void addOwn(QStringList& texts, QWidget& widget)
{
    texts << widget.windowTitle() << widget.toolTip() << widget.statusTip() << widget.whatsThis()
          << widget.accessibleName() << widget.accessibleDescription();
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        texts << label->text();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        texts << button->text();
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        texts << line->placeholderText();
    if (const auto* page = qobject_cast<const QTextEdit*>(&widget))
        texts << page->toPlainText().split(QLatin1Char('\n')) << page->placeholderText();
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
        texts << group->title();
    if (const auto* menu = qobject_cast<const QMenu*>(&widget))
        texts << menu->title();
    if (const auto* slider = qobject_cast<const view::BarSlider*>(&widget))
        texts << slider->label() << slider->valueText();
    if (const auto* box = qobject_cast<const QComboBox*>(&widget))
        addModel(texts, *box->model(), {});
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        for (int i = 0; i < tabs->count(); ++i)
            texts << tabs->tabText(i) << tabs->tabToolTip(i);
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
        view != nullptr && view->model() != nullptr && qobject_cast<const QHeaderView*>(&widget) == nullptr) {
        addModel(texts, *view->model(), {});
        for (int i = 0; i < view->model()->columnCount(); ++i)
            texts << view->model()->headerData(i, Qt::Horizontal).toString();
    }
    for (const QAction* action : widget.actions())
        texts << action->text() << action->iconText() << action->toolTip() << action->statusTip()
              << action->shortcut().toString(QKeySequence::NativeText);
    if (widget.isVisible() && widget.toolTip().isEmpty()) { // Some tooltips are made when they are asked for.
        const QPoint middle = widget.rect().center();
        QHelpEvent ask(QEvent::ToolTip, middle, widget.mapToGlobal(middle));
        QCoreApplication::sendEvent(&widget, &ask);
        if (ask.isAccepted())
            texts << QToolTip::text();
    }
}

} // namespace

QStringList paintedTexts(QWidget& widget)
{
    TextDevice device(widget.size());
    widget.render(&device);
    return device.texts();
}

QStringList carriedTexts(QWidget& widget)
{
    QStringList texts;
    addOwn(texts, widget);
    // A tooltip is a child too, and goes as the next one comes.
    QList<QPointer<QWidget>> children;
    for (QWidget* child : widget.findChildren<QWidget*>())
        children.append(child);
    for (const QPointer<QWidget>& child : children)
        if (child != nullptr)
            addOwn(texts, *child);
    QToolTip::hideText();
    for (QString& text : texts)
        if (Qt::mightBeRichText(text))
            text = QTextDocumentFragment::fromHtml(text).toPlainText();
    texts.removeAll(QString());
    texts.removeDuplicates();
    return texts;
}

} // namespace hairpaint::test
