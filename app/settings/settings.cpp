// The program's memory: see the header.
#include "app/settings/settings.h"

#include <QStandardPaths>

#include <algorithm>

namespace hairpaint::app {

namespace {

constexpr qsizetype kRecentFiles = 10;
constexpr double kFarthestPx = 1e6; ///< From the screen's corner; no screen is so large.

} // namespace

view::Preferences Settings::preferences() const
{
    view::Preferences preferences;
    if (m_settings.value(QStringLiteral("theme")).toString() == QLatin1String("light"))
        preferences.theme = view::ThemeKind::Light;
    preferences.language = m_settings.value(QStringLiteral("language")).toString();
    const int presenter = m_settings.value(QStringLiteral("presenter"), 0).toInt();
    preferences.presenter = static_cast<view::PresenterChoice>(std::clamp(presenter, 0, 2));
    preferences.whitePaper = m_settings.value(QStringLiteral("whitePaper"), false).toBool();
    preferences.earlierVersions = m_settings.value(QStringLiteral("earlierVersions"), false).toBool();
    return preferences;
}

void Settings::setPreferences(const view::Preferences& preferences)
{
    m_settings.setValue(QStringLiteral("theme"),
                        preferences.theme == view::ThemeKind::Light ? QStringLiteral("light") : QStringLiteral("dark"));
    m_settings.setValue(QStringLiteral("language"), preferences.language);
    m_settings.setValue(QStringLiteral("presenter"), static_cast<int>(preferences.presenter));
    m_settings.setValue(QStringLiteral("whitePaper"), preferences.whitePaper);
    m_settings.setValue(QStringLiteral("earlierVersions"), preferences.earlierVersions);
}

QByteArray Settings::windowGeometry() const
{
    return m_settings.value(QStringLiteral("geometry")).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry)
{
    m_settings.setValue(QStringLiteral("geometry"), geometry);
}

QStringList Settings::recentFiles() const
{
    return m_settings.value(QStringLiteral("recentFiles")).toStringList();
}

void Settings::addRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    m_settings.setValue(QStringLiteral("recentFiles"), files.mid(0, kRecentFiles));
}

void Settings::removeRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    m_settings.setValue(QStringLiteral("recentFiles"), files);
}

QString Settings::lastFolder() const
{
    return m_settings
        .value(QStringLiteral("lastFolder"), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
        .toString();
}

void Settings::setLastFolder(const QString& folder)
{
    m_settings.setValue(QStringLiteral("lastFolder"), folder);
}

bool Settings::viewTurned() const
{
    return m_settings.value(QStringLiteral("viewTurned")).toBool();
}

void Settings::setViewTurned()
{
    m_settings.setValue(QStringLiteral("viewTurned"), true);
}

QString Settings::avatarAuthor() const
{
    return m_settings.value(QStringLiteral("avatarAuthor")).toString();
}

void Settings::setAvatarAuthor(const QString& author)
{
    m_settings.setValue(QStringLiteral("avatarAuthor"), author);
}

view::PictureChoice Settings::pictureChoice() const
{
    view::PictureChoice choice;
    const QVariantMap map = m_settings.value(QStringLiteral("picture")).toMap();
    const auto number = [&map](const char* key, int otherwise, int least, int most) {
        return std::clamp(map.value(QLatin1String(key), otherwise).toInt(), least, most);
    };
    choice.isAsView = map.value(QStringLiteral("asView"), choice.isAsView).toBool();
    choice.size = {number("width", choice.size.width(), choice.kLeastPx, choice.kMostPx),
                   number("height", choice.size.height(), choice.kLeastPx, choice.kMostPx)};
    choice.keepsShape = map.value(QStringLiteral("keepsShape"), choice.keepsShape).toBool();
    choice.framing = static_cast<view::PictureFraming>(number("framing", 0, 0, 3));
    choice.background = static_cast<view::PictureBackground>(number("background", 0, 0, 2));
    if (const QColor colour(map.value(QStringLiteral("colour")).toString()); colour.isValid())
        choice.colour = colour;
    choice.samples = number("samples", choice.samples, 1, 16);
    return choice;
}

void Settings::setPictureChoice(const view::PictureChoice& choice)
{
    m_settings.setValue(QStringLiteral("picture"),
                        QVariantMap{{QStringLiteral("asView"), choice.isAsView},
                                    {QStringLiteral("width"), choice.size.width()},
                                    {QStringLiteral("height"), choice.size.height()},
                                    {QStringLiteral("keepsShape"), choice.keepsShape},
                                    {QStringLiteral("framing"), static_cast<int>(choice.framing)},
                                    {QStringLiteral("background"), static_cast<int>(choice.background)},
                                    {QStringLiteral("colour"), choice.colour.name()},
                                    {QStringLiteral("samples"), choice.samples}});
}

view::StyleMarks Settings::styleMarks() const
{
    view::StyleMarks marks;
    for (const QString& path : m_settings.value(QStringLiteral("styles/favourites")).toStringList())
        marks.setFavourite(path, true);
    marks.recent = m_settings.value(QStringLiteral("styles/recent")).toStringList().mid(0, marks.kMostRecent);
    return marks;
}

void Settings::setStyleMarks(const view::StyleMarks& marks)
{
    m_settings.setValue(QStringLiteral("styles/favourites"), marks.favourites);
    m_settings.setValue(QStringLiteral("styles/recent"), marks.recent);
}

std::optional<double> Settings::toolOption(const QString& key) const
{
    bool isNumber = false;
    const double value = m_settings.value(QStringLiteral("tools/") + key).toDouble(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
}

void Settings::setToolOption(const QString& key, double value)
{
    m_settings.setValue(QStringLiteral("tools/") + key, value);
}

std::optional<QPoint> Settings::dialogPosition(const QString& dialog) const
{
    const QVariantList position = m_settings.value(QStringLiteral("places/") + dialog).toList();
    if (position.size() != 2)
        return std::nullopt;
    const auto coordinate = [](const QVariant& value) {
        return static_cast<int>(std::clamp(value.toDouble(), -kFarthestPx, kFarthestPx));
    };
    return QPoint(coordinate(position[0]), coordinate(position[1]));
}

void Settings::setDialogPosition(const QString& dialog, QPoint position)
{
    m_settings.setValue(QStringLiteral("places/") + dialog, QVariantList{position.x(), position.y()});
}

std::optional<QKeySequence> Settings::key(const QString& actionId) const
{
    const QVariant value = m_settings.value(QStringLiteral("keys/") + actionId);
    if (!value.isValid())
        return std::nullopt;
    return QKeySequence(value.toString(), QKeySequence::PortableText);
}

void Settings::setKey(const QString& actionId, const QKeySequence& key)
{
    m_settings.setValue(QStringLiteral("keys/") + actionId, key.toString(QKeySequence::PortableText));
}

void Settings::removeKey(const QString& actionId)
{
    m_settings.remove(QStringLiteral("keys/") + actionId);
}

} // namespace hairpaint::app
