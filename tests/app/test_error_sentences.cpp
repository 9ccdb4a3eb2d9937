// What a user is told where a file can't be read or written: every sentence names the file, says why, and how to go on.
// The texts come from translations/, which hold every text of the sources; where they are used, from the sources.
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QtTest>

using namespace hairpaint;

namespace {

/// Texts that need not keep a rule, each with the reason.
using Exceptions = QMap<QString, QString>;

/// The texts of the sources by their contexts.
QMultiMap<QString, QString> allTexts()
{
    QFile file(test::sourcePath(u"translations/hairpaint_es.ts"));
    QMultiMap<QString, QString> texts;
    if (!file.open(QIODevice::ReadOnly))
        return texts;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("source"))
            texts.insert(context, xml.readElementText());
    }
    return texts;
}

/// The sources by their paths, string literals that stand one behind the other joined.
QMap<QString, QString> allSources()
{
    static const QRegularExpression joint(QStringLiteral("(?<!\\\\)\"\\s+\""));
    QMap<QString, QString> sources;
    for (const char* folder : {"app", "model", "view"}) {
        const QDir top(test::sourcePath(u""));
        QDirIterator files(top.filePath(QString::fromLatin1(folder)), {QStringLiteral("*.cpp")}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (file.open(QIODevice::ReadOnly))
                sources.insert(top.relativeFilePath(file.fileName()),
                               QString::fromUtf8(file.readAll()).replace(joint, QString()));
        }
    }
    return sources;
}

bool isClause(const QString& text)
{
    return !text.endsWith(QLatin1Char('.')) && (text.front().isLower() || text.startsWith(QLatin1String("%1; ")));
}

/// Behind a semicolon or a colon, or in a sentence of its own.
bool saysHowToGoOn(const QString& text)
{
    static const QRegularExpression more(QStringLiteral("(; |: (?!%\\d\\.$)|[.?] )\\S"));
    return text.contains(more);
}

/// Reasons for which the sentence around them says to try an earlier copy or a newer program.
const QStringList& reasonsOfDamage()
{
    static const QStringList reasons = {
        QStringLiteral("its archive is cut short or broken"),
        QStringLiteral("it holds more than %1 entries"),
        QStringLiteral("one of its entries has an unacceptable name"),
        QStringLiteral("it holds two entries named '%1'"),
        QStringLiteral("its entry '%1' is packed in an unacceptable way"),
        QStringLiteral("its entry '%1' is missing"),
        QStringLiteral("its entry '%1' is too large"),
        QStringLiteral("its entry '%1' is broken"),
        QStringLiteral("its head's mesh is broken"),
        QStringLiteral("it holds no hair group, or too many"),
        QStringLiteral("its map '%1' is not known to this one"),
        QStringLiteral("its list of groups, maps and layers is broken"),
        QStringLiteral("'%1' in project.json is not what it should be"),
        QStringLiteral("its format version is missing"),
        QStringLiteral("its format is %1, and this Hair Paint reads up to %2"),
        QStringLiteral("one of its images is broken"),
        QStringLiteral("one of its images is not %1 x %1 in 16-bit RGBA"),
        QStringLiteral("its head '%1' is not known to this one"),
        QStringLiteral("its project.json is too large or nested too deep"),
        QStringLiteral("its project.json can't be understood"),
        QStringLiteral("something worn in it is of a kind that is not known to this one"),
        QStringLiteral("its way of drawing roots is not known to this one"),
        QStringLiteral("what it holds is damaged"),
    };
    return reasons;
}

const Exceptions& otherClauses()
{
    static const Exceptions exceptions = {
        {QStringLiteral("an earlier part of it could not be written"),
         QStringLiteral("of the journal, beside which the window says to save now and then")},
        {QStringLiteral("tiles that the head has not are left out: %1"),
         QStringLiteral("a remark on maps that came in")},
        {QStringLiteral("its uv tiles lie side by side on the maps: 1001, %1"),
         QStringLiteral("a remark on a head that came in")},
        {QStringLiteral("without uv coordinates, so no hair grows there: %1"),
         QStringLiteral("a remark on a head that came in")},
    };
    return exceptions;
}

const Exceptions& otherSentences()
{
    static const Exceptions exceptions = {
        {QStringLiteral("“%1” has this key now and will lose it."), QStringLiteral("of a key, while it is chosen")},
        {QStringLiteral("'%1' has changes that are not saved."), QStringLiteral("a question's; its buttons go on")},
        {QStringLiteral("'%1' can't be opened: %2."), QStringLiteral("its reasons say how to go on")},
        {QStringLiteral("'%1' can't be written: %2."), QStringLiteral("its reasons say how to go on")},
        {QStringLiteral("Settings of the group '%1' are lost; the usual ones take their place."),
         QStringLiteral("a repair's list")},
        {QStringLiteral("'%2' of the group '%1' is lost; the usual takes its place."),
         QStringLiteral("a repair's list")},
        {QStringLiteral("The map '%2' of the group '%1' is lost."), QStringLiteral("a repair's list")},
        {QStringLiteral("Name, order and blending of the layer '%3' of %2 in the group '%1' are lost; its paint is "
                        "there."),
         QStringLiteral("a repair's list")},
        {QStringLiteral("The paint of the layer '%3' of %2 in the group '%1' is lost."),
         QStringLiteral("a repair's list")},
        {QStringLiteral("The lower %4 % of the paint of the layer '%3' of %2 in the group '%1' are lost."),
         QStringLiteral("a repair's list")},
        {QStringLiteral(
             "All hair of “%1” becomes shorter by as much; what is shorter than hair may become stays as it is."),
         QStringLiteral("what a cut does to a group")},
        {QStringLiteral("Each hair of “%1” that hangs lower ends there, as it lies now."),
         QStringLiteral("what a cut does to a group")},
        {QStringLiteral("Hair of “%1” is cut by its distance from the crown; what is shorter stays as it is."),
         QStringLiteral("what a cut does to a group")},
        {QStringLiteral("Hair of “%1” becomes shorter from the top down to the skin at the sides and the nape; what is "
                        "shorter stays as it is."),
         QStringLiteral("what a cut does to a group")},
    };
    return exceptions;
}

} // namespace

class TestErrorSentences : public QObject
{
    Q_OBJECT
private:
    QMultiMap<QString, QString> m_texts;
    QMap<QString, QString> m_sources;

private Q_SLOTS:
    void initTestCase()
    {
        m_texts = allTexts();
        m_sources = allSources();
        QVERIFY(m_texts.size() > 400);
        QVERIFY(m_sources.size() > 200);
    }

    void whatNamesAFileSaysHowToGoOn()
    {
        static const QRegularExpression name(QStringLiteral("['“]%\\d['”]"));
        int found = 0;
        for (auto text = m_texts.cbegin(); text != m_texts.cend(); ++text) {
            if (!text->contains(name) || !text->endsWith(QLatin1Char('.')) || otherSentences().contains(*text))
                continue;
            ++found;
            QVERIFY2(saysHowToGoOn(*text), qPrintable(text.key() + QStringLiteral(": ") + *text));
        }
        QVERIFY(found > 20);
    }

    void everyReasonSaysHowToGoOnOrIsDamage()
    {
        int found = 0;
        for (const char* context : {"Files", "Picture", "hairpaint::app::Journal"})
            for (const QString& text : m_texts.values(QString::fromLatin1(context))) {
                if (!isClause(text) || reasonsOfDamage().contains(text) || otherClauses().contains(text))
                    continue;
                ++found;
                QVERIFY2(text.contains(QLatin1String("; ")), qPrintable(text));
            }
        QVERIFY(found > 30);
    }

    /// Then the sentence around it would not say how to go on.
    void noReasonOfDamageIsGivenForAnotherFile()
    {
        for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source)
            for (const QString& statement : source->split(QStringLiteral(";\n")))
                if (statement.contains(QLatin1String("OtherFile")) || statement.contains(QLatin1String("cannotWrite(")))
                    for (const QString& reason : reasonsOfDamage())
                        QVERIFY2(!statement.contains(QLatin1Char('"') + reason + QLatin1Char('"')),
                                 qPrintable(source.key() + QStringLiteral(": ") + reason));
    }

    void everyFailureNamesTheFile()
    {
        // Where no file is known; the window or the command line names what it was about.
        const Exceptions nameless = {
            {QStringLiteral("Drawing the picture was cancelled."), QStringLiteral("the user did it")},
            {QStringLiteral("There is no hair to hold in this group."), QStringLiteral("of no file")},
            {QStringLiteral("Nothing to hold: this hair hangs by its weight, or its gel holds it already."),
             QStringLiteral("of no file")},
            {QStringLiteral("The image holds no pixels; choose another."), QStringLiteral("of pixels in memory")},
        };
        static const QRegularExpression failure(
            QStringLiteral("\\bfailure\\(\\s*(?:[\\w:]*(?:tr|say|translate)\\()[^;]*?\"([^\"]*[.;:][^\"]*)\""));
        int found = 0;
        for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source)
            for (auto match = failure.globalMatch(*source); match.hasNext(); ++found) {
                const QString text = match.next().captured(1);
                QVERIFY2(text.contains(QLatin1String("%1")) || nameless.contains(text),
                         qPrintable(source.key() + QStringLiteral(": ") + text));
            }
        QVERIFY(found >= 6);
    }

    void whatTheSystemSaysComesWithAdvice()
    {
        static const QRegularExpression said(
            QStringLiteral("(errorString\\(\\)|qt_error_string\\(|problem\\.message\\(\\))"));
        int found = 0;
        for (auto source = m_sources.cbegin(); source != m_sources.cend(); ++source)
            for (const QString& statement : source->split(QStringLiteral(";\n"))) {
                if (!statement.contains(said) || source.key().startsWith(QLatin1String("app/importer/")))
                    continue;
                ++found;
                QVERIFY2(statement.contains(QLatin1String("Refusal(")),
                         qPrintable(source.key() + QStringLiteral(": ") + statement.simplified()));
            }
        QVERIFY(found >= 8);
    }

    void noExceptionIsKeptForATextThatIsGone()
    {
        const QStringList there = m_texts.values();
        for (const QString& text : reasonsOfDamage() + otherClauses().keys() + otherSentences().keys())
            QVERIFY2(there.contains(text), qPrintable(text));
    }
};

HAIRPAINT_TEST(TestErrorSentences, Core)
#include "test_error_sentences.moc"
