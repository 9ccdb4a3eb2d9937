// Finds and installs translations: see the header.
#include "app/settings/languages.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <algorithm>
#include <memory>

/// Resources of a static library are registered on request; the macro must stand outside every namespace.
static void initTranslationResources() // NOLINT(misc-use-anonymous-namespace)
{
    Q_INIT_RESOURCE(translations);
}

namespace hairpaint::app {

namespace {

const QString kFolder = QStringLiteral(":/i18n");
const QString kPrefix = QStringLiteral("hairpaint_");
/// The sources' own; its file holds only the plurals.
const QString kSourceLanguage = QStringLiteral("en");

QString ownName(const QString& code)
{
    QTranslator translator;
    //: What your language calls itself, with a capital letter: it stands so in the Preferences.
    constexpr const char* kName = QT_TRANSLATE_NOOP("Languages", "English");
    const QString name =
        translator.load(kPrefix + code, kFolder) ? translator.translate("Languages", kName) : QString();
    return name.isEmpty() ? QString::fromLatin1(kName) : name;
}

void install(std::unique_ptr<QTranslator> translator)
{
    translator->setParent(QCoreApplication::instance());
    QCoreApplication::installTranslator(translator.release());
}

/// What Qt's own dialogs and buttons say: its package's folder on Linux, the program's folder on Windows.
void installQtCatalogue(const QString& code)
{
    auto translator = std::make_unique<QTranslator>();
    for (const QString& folder : {QLibraryInfo::path(QLibraryInfo::TranslationsPath),
                                  QCoreApplication::applicationDirPath() + QStringLiteral("/translations")})
        if (translator->load(QLocale(code), QStringLiteral("qtbase"), QStringLiteral("_"), folder))
            return install(std::move(translator));
}

} // namespace

std::vector<std::pair<QString, QString>> languages()
{
    initTranslationResources();
    std::vector<std::pair<QString, QString>> found;
    for (const QString& file : QDir(kFolder).entryList({kPrefix + QStringLiteral("*.qm")})) {
        const QString code = file.mid(kPrefix.size()).chopped(3);
        found.emplace_back(code, ownName(code));
    }
    std::ranges::sort(found, {}, &std::pair<QString, QString>::second);
    return found;
}

QString speak(const QString& code)
{
    initTranslationResources();
    auto translator = std::make_unique<QTranslator>();
    QString spoken = code;
    if (code.isEmpty() || !translator->load(kPrefix + code, kFolder)) {
        // Tries each language that the system prefers, "es" for "es-MX" too.
        if (translator->load(QLocale::system(), QStringLiteral("hairpaint"), QStringLiteral("_"), kFolder))
            spoken = QFileInfo(translator->filePath()).baseName().mid(kPrefix.size());
        else if (translator->load(kPrefix + kSourceLanguage, kFolder))
            spoken = kSourceLanguage;
    } else if (QLocale::system().language() != QLocale(code).language()) {
        QLocale::setDefault(QLocale(code));
    }
    if (spoken != kSourceLanguage)
        installQtCatalogue(spoken);
    install(std::move(translator)); // Last, so asked first.
    return spoken;
}

} // namespace hairpaint::app
