// The help's pages, as one text with anchors.
#include "view/dialogs/help_dialog.h"

#include "view/look/theme.h"

#include <QDialogButtonBox>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hairpaint::view {

namespace {

QString anchorOf(HelpDialog::Topic topic)
{
    return QStringLiteral("topic%1").arg(static_cast<int>(topic));
}

QString anchorOf(const model::Tool& tool)
{
    return QStringLiteral("tool-") + QLatin1String(tool.name());
}

QString heading(HelpDialog::Topic topic, const QString& title)
{
    return QStringLiteral("<h3><a name=\"%1\"></a>%2</h3>").arg(anchorOf(topic), title.toHtmlEscaped());
}

QString paragraph(const QString& text)
{
    return QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped());
}

/// A table of what is done how.
class Table
{
public:
    void row(const QString& what, const QString& how)
    {
        m_rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                      .arg(how.toHtmlEscaped(), what.toHtmlEscaped());
    }
    /// What says by itself what is done, and perhaps more on it below.
    void wideRow(const QString& what, const QString& more = {})
    {
        m_rows +=
            QStringLiteral("<tr><td colspan=\"2\"><b>%1</b>%2</td></tr>")
                .arg(what.toHtmlEscaped(), more.isEmpty() ? QString() : QStringLiteral("<br>") + more.toHtmlEscaped());
    }
    [[nodiscard]] QString html() const
    {
        return m_rows.isEmpty() ? QString() : QStringLiteral("<table cellpadding=\"3\">%1</table>").arg(m_rows);
    }

private:
    QString m_rows;
};

/// The key that an action has now; empty where it has none, or where there is no such action.
QString keyOf(const std::vector<KeyBinding>& bindings, const QString& action)
{
    const auto found =
        std::ranges::find(bindings, action, [](const KeyBinding& one) { return one.action->objectName(); });
    return found != bindings.end() ? found->action->shortcut().toString(QKeySequence::NativeText) : QString();
}

QString rangeText(const model::ToolNumber& number)
{
    const auto text = [&number](double value) { return QLocale().toString(value, 'f', number.decimals); };
    return text(number.least) + QChar(0x2013) + text(number.greatest) + QChar(QChar::Nbsp) + number.unitText();
}

/// What a tool can be set to.
QString optionTable(const model::Tool& tool)
{
    Table table;
    for (const model::ToolOption* option : tool.options()) {
        if (const auto* choice = std::get_if<model::ToolChoice>(&option->kind)) {
            for (const model::ToolChoice::Item& entry : choice->entries)
                table.wideRow(entry.titleText(), *entry.hint != '\0' ? model::Tool::tr(entry.hint) : QString());
            continue;
        }
        QStringList told;
        if (const auto* number = std::get_if<model::ToolNumber>(&option->kind))
            told += rangeText(*number);
        if (*option->hint != '\0')
            told += option->hintText();
        if (told.isEmpty())
            table.wideRow(option->labelText());
        else
            table.row(told.join(QStringLiteral("; ")), option->labelText());
    }
    return table.html();
}

QString toolPage(const EditorState& state, const std::vector<KeyBinding>& bindings)
{
    QString html = heading(HelpDialog::Topic::Tools, HelpDialog::tr("Tools")) +
                   paragraph(HelpDialog::tr(
                       "Tools work in both areas, on the flat map and straight on the head; scissors cut hair "
                       "that is seen. What a tool paints goes to the active layer of the active map, inside "
                       "the selection where there is one."));
    for (const auto& tool : state.tools().all()) {
        const QString key = keyOf(bindings, QStringLiteral("tool.") + QLatin1String(tool->name()));
        html += QStringLiteral("<h4><a name=\"%1\"></a>%2</h4>")
                    .arg(anchorOf(*tool),
                         (key.isEmpty() ? tool->title() : QStringLiteral("%1 (%2)").arg(tool->title(), key))
                             .toHtmlEscaped()) +
                paragraph(tool->purpose()) + paragraph(tool->hint()) + optionTable(*tool);
    }
    return html;
}

QString pointerPage(const std::vector<KeyBinding>& bindings)
{
    Table table;
    const QString smaller = keyOf(bindings, QStringLiteral("tool.smaller"));
    const QString larger = keyOf(bindings, QStringLiteral("tool.larger"));
    table.row(HelpDialog::tr("Paint the first ten maps"), HelpDialog::tr("1 to 9, and 0"));
    table.row(HelpDialog::tr("See a map's colours on the hair"), HelpDialog::tr("Hold Alt and 1 to 9, or 0"));
    if (!smaller.isEmpty() && !larger.isEmpty())
        table.row(HelpDialog::tr("Make the brush smaller or larger"), HelpDialog::tr("%1 and %2").arg(smaller, larger));
    table.row(HelpDialog::tr("Size sideways, hardness up and down"), HelpDialog::tr("Ctrl and right-drag"));
    table.row(HelpDialog::tr("Opacity"), HelpDialog::tr("Hold O and drag"));
    table.row(HelpDialog::tr("Straight line from the last point"), HelpDialog::tr("Shift and click"));
    table.row(HelpDialog::tr("Pick the value under the pointer"), HelpDialog::tr("Ctrl and click"));
    table.row(HelpDialog::tr("Cancel the stroke"), HelpDialog::tr("Esc"));
    table.row(HelpDialog::tr("Move the map; rotate it"), HelpDialog::tr("Space and drag; Shift, Space and drag"));
    table.row(HelpDialog::tr("Zoom at the pointer"), HelpDialog::tr("Wheel"));
    table.row(HelpDialog::tr("3D area: turn the view"), HelpDialog::tr("Drag the background, or right-drag"));
    table.row(HelpDialog::tr("3D area: move the view"), HelpDialog::tr("Middle drag"));
    table.row(HelpDialog::tr("3D area: turn the light"), HelpDialog::tr("Shift and right-drag"));
    table.row(HelpDialog::tr("3D area: turn the head, so that the hair swings"), HelpDialog::tr("Hold H and drag"));
    table.row(HelpDialog::tr("Within an area of the window; pick"), HelpDialog::tr("Tab and arrows; Enter"));
    table.row(HelpDialog::tr("From a panel back to the map"), HelpDialog::tr("Esc"));
    return heading(HelpDialog::Topic::Pointer, HelpDialog::tr("Pointer")) + table.html();
}

QString keyPage(const std::vector<KeyBinding>& bindings)
{
    QString html = heading(HelpDialog::Topic::Keys, HelpDialog::tr("Keys"));
    QString section;
    Table table;
    const auto finish = [&] {
        if (!section.isEmpty())
            html += QStringLiteral("<h4>%1</h4>").arg(section.toHtmlEscaped()) + table.html();
        table = {};
    };
    for (const KeyBinding& binding : bindings) {
        if (binding.action->shortcut().isEmpty())
            continue;
        if (binding.section != section)
            finish();
        section = binding.section;
        table.row(binding.name, binding.action->shortcut().toString(QKeySequence::NativeText));
    }
    finish();
    return html;
}

QString dialogPages()
{
    using Topic = HelpDialog::Topic;
    return heading(Topic::Wind, HelpDialog::tr("Wind")) +
           paragraph(HelpDialog::tr("Direction and speed of the wind; gusts let it come and go, turbulence makes it "
                                    "differ from place to place. The hair shows every change at once, and letting go "
                                    "is one step to undo.")) +
           heading(Topic::Light, HelpDialog::tr("Light")) +
           paragraph(HelpDialog::tr("The buttons are whole arrangements to start from. Where the key light stands, how "
                                    "strong it is and its colour; the fill follows the camera, the rim light stands "
                                    "behind the head and shines through the hair's tips, the surroundings brighten "
                                    "the shadows from all sides. The background is the picture's own.")) +
           heading(Topic::ScaleHair, HelpDialog::tr("Scale the hair")) +
           paragraph(HelpDialog::tr("Makes all hair of the active group longer, denser or more widely curled by a "
                                    "percentage, and shows it at once. The ranges of the maps (Greatest length, "
                                    "Greatest density, Curl radius) are another thing: they say how far a map "
                                    "reaches, and what is painted stays as long, dense and wide as it is. Hair beyond "
                                    "a narrower range is cut to it.")) +
           heading(Topic::Cut, HelpDialog::tr("Cut")) +
           paragraph(
               HelpDialog::tr("Hair > Cut shortens all hair of the active group, inside the selection if there is "
                              "one, and shows it at once. Trim takes as much from every hair. Cut to a level ends "
                              "each hair where it first goes below a height, as it lies now: let it come to rest "
                              "before. Layers cuts by the distance from the crown, Fade by the height; both leave "
                              "what is shorter as it is, and where they begin and end is counted from the crown "
                              "(0 %) down to the nape (100 %).")) +
           heading(Topic::Rows, HelpDialog::tr("Repeat between two rows")) +
           paragraph(
               HelpDialog::tr("Each stroke of Cornrow on the braid map is a row, also where it touches another; a "
                              "stroke that begins on a row goes on with it. Hair > Tie and put on > Repeat between "
                              "two rows paints more between the two that were painted last, or the two that reach "
                              "into the selection, evenly over the skin and on the other side of the head too where "
                              "strokes are mirrored.")) +
           heading(Topic::HeadImport, HelpDialog::tr("Import head")) +
           paragraph(
               HelpDialog::tr("A mesh says neither its unit nor which way is up, so both are guessed: the picture "
                              "shows the head beside its height. Set them right before it becomes the head; it "
                              "needs uv coordinates, which the maps lie on.")) +
           paragraph(HelpDialog::tr(
               "Where the hairstyle is carried over, seven landmarks bring both heads together. They are "
               "found by the head's shape; drag one to where it lies on the left head if it was not "
               "found right. File > Replace head > Landmarks shows them again, and hair goes along.")) +
           heading(Topic::HairImport, HelpDialog::tr("Import hair")) +
           paragraph(HelpDialog::tr("Hair of other programs, as .hair or USD, becomes a hair group: density, length, "
                                    "direction, curl, braids "
                                    "and colours are told from its curves and painted into the maps. Unit and axes "
                                    "need to be set only where "
                                    "the hair comes in too large, too small or lying on its side.")) +
           heading(Topic::HairExport, HelpDialog::tr("Export hair")) +
           paragraph(HelpDialog::tr(
               "The format says what the file holds, the program whose unit and axes it is written in. USD has the "
               "guides and attributes that Unreal reads; Blender reads the curves of .hair with the add-on that File > "
               "Install Blender add-on puts there.")) +
           paragraph(HelpDialog::tr("Fewer hairs are an even share of all. A tolerance leaves out points that lie so "
                                    "near to the line without them that they are hardly missed.")) +
           paragraph(HelpDialog::tr(
               "Cards are strips of hair with textures, for games and avatars. Preview, or View > Hair as cards, shows "
               "them in the 3D area in place of the hair, until that is changed, with the number of their "
               "triangles.")) +
           paragraph(HelpDialog::tr("The dialog stays open meanwhile: turn the head to see the cards from all sides, "
                                    "choose otherwise and ask for a preview again.")) +
           paragraph(HelpDialog::tr(
               "A head whose file had a whole body's skeleton goes out with it as a VRM avatar: the hair swings on the "
               "head's bone. Bones are told by their names, as Mixamo, Unreal, Blender, VRoid and others have them; "
               "arms that hang are held out to the sides, as VRM wants it.")) +
           paragraph(HelpDialog::tr(
               "File > Import hair curves goes the other way: curves of .hair files and USD text become a new hair "
               "group, whose maps are told from the strands. A file that tells no unit is placed as it fits the "
               "head.")) +
           heading(Topic::MapExport, HelpDialog::tr("Save maps as images")) +
           paragraph(HelpDialog::tr(
               "Each map becomes an image named after its group and itself. In the colours of their scales maps look "
               "as "
               "they do here, and File > Load image reads them; as grey their brightness is the value, which File > "
               "Load grey image reads. Colours and directions are the same both ways.")) +
           heading(Topic::Picture, HelpDialog::tr("Save picture")) +
           paragraph(HelpDialog::tr(
               "The small picture shows what will be saved; turn the head in the 3D area while the dialog is open, and "
               "it follows. The ending of the file's name says its kind: PNG, JPEG, or OpenEXR in linear light for "
               "compositing. More samples a pixel make finer hair and take longer.")) +
           heading(Topic::Preferences, HelpDialog::tr("Preferences")) +
           paragraph(
               HelpDialog::tr("Theme, paper, language and what draws the 3D area; and all keys, each of which can "
                              "be set anew."));
}

} // namespace

HelpDialog::HelpDialog(const EditorState& state, std::vector<KeyBinding> bindings, QWidget* parent)
    : QDialog(parent), m_state(state), m_bindings(std::move(bindings)), m_browser(new QTextBrowser(this))
{
    setWindowTitle(tr("Help"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kPadding, metrics::kPadding, metrics::kPadding, metrics::kPadding);
    m_browser->setAccessibleName(tr("Help"));
    write();
    // Once for all keys that change together.
    m_rewrite.setSingleShot(true);
    m_rewrite.setInterval(0);
    connect(&m_rewrite, &QTimer::timeout, this, &HelpDialog::write);
    for (const KeyBinding& binding : m_bindings)
        connect(binding.action, &QAction::changed, &m_rewrite, qOverload<>(&QTimer::start));
    layout->addWidget(m_browser);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout->addWidget(buttons);
    resize(620, 640);
}

void HelpDialog::write()
{
    const QString html = toolPage(m_state, m_bindings) + pointerPage(m_bindings) + keyPage(m_bindings) + dialogPages();
    if (html == m_html)
        return; // Actions change for other reasons than their keys.
    m_html = html;
    const int read = m_browser->verticalScrollBar()->value();
    m_browser->setHtml(html);
    m_browser->verticalScrollBar()->setValue(read);
}

void HelpDialog::showTopic(Topic topic)
{
    show();
    raise();
    activateWindow();
    m_browser->scrollToAnchor(topic == Topic::Tools ? anchorOf(m_state.tools().active()) : anchorOf(topic));
}

QString HelpDialog::text() const
{
    return m_browser->toPlainText();
}

} // namespace hairpaint::view
