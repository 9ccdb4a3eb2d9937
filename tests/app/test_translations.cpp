// The files of translations/: they hold every text of the sources, whole, and say what the texts need said.
#include "tests/support/locations.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include <tuple>

using namespace hairpaint;

namespace {

struct Message
{
    QString context;
    QString source;
    QString comment;
    QString state; ///< "unfinished", "vanished", "obsolete" or nothing.
    bool numerus = false;
    QStringList forms;

    [[nodiscard]] auto key() const { return std::tuple(context, source, comment); }
    [[nodiscard]] QString shown() const { return context + QStringLiteral(": ") + source; }
};

QList<Message> messagesOf(const QString& path)
{
    QFile file(path);
    QList<Message> messages;
    if (!file.open(QIODevice::ReadOnly))
        return messages;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QStringView name = xml.name();
        if (name == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (name == QLatin1String("message")) {
            const bool numerus = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
            messages.append(Message());
            messages.back().context = context;
            messages.back().numerus = numerus;
        } else if (name == QLatin1String("source")) {
            messages.back().source = xml.readElementText();
        } else if (name == QLatin1String("comment")) {
            messages.back().comment = xml.readElementText();
        } else if (name == QLatin1String("translation")) {
            messages.back().state = xml.attributes().value(QLatin1String("type")).toString();
            if (!messages.back().numerus)
                messages.back().forms.append(xml.readElementText());
        } else if (name == QLatin1String("numerusform")) {
            messages.back().forms.append(xml.readElementText());
        }
    }
    return xml.hasError() ? QList<Message>() : messages;
}

QString pathOf(const QString& language)
{
    return test::sourcePath(u"translations/hairpaint_%1.ts").arg(language);
}

/// Every match of a pattern, sorted: what a translation must have as often as its source.
QStringList partsOf(const QString& text, const char* pattern)
{
    QStringList parts;
    for (auto match = QRegularExpression(QString::fromLatin1(pattern)).globalMatch(text); match.hasNext();)
        parts.append(match.next().captured());
    parts.sort();
    return parts;
}

} // namespace

class TestTranslations : public QObject
{
    Q_OBJECT
private:
    static void eachLanguage()
    {
        QTest::addColumn<QString>("language");
        for (const QString& file :
             QDir(test::sourcePath(u"translations")).entryList({QStringLiteral("hairpaint_*.ts")}, QDir::Files)) {
            const QString language = file.mid(10).chopped(3);
            QTest::newRow(qPrintable(language)) << language;
        }
    }

private Q_SLOTS:
    void theFilesHoldExactlyTheTextsOfTheSources_data() { eachLanguage(); }
    void theFilesHoldExactlyTheTextsOfTheSources()
    {
        QFETCH(QString, language);
        QTemporaryDir folder;
        const QString copy = folder.filePath(QStringLiteral("hairpaint_%1.ts").arg(language));
        QVERIFY(QFile::copy(pathOf(language), copy));
        QStringList arguments = QStringLiteral(HAIRPAINT_LUPDATE_ARGUMENTS).split(QLatin1Char(' '));
        if (language == QLatin1String("en"))
            arguments += QStringLiteral("-pluralonly");
        QProcess lupdate;
        lupdate.setWorkingDirectory(test::sourcePath(u""));
        lupdate.start(QStringLiteral(HAIRPAINT_LUPDATE_PROGRAM), arguments + QStringList{QStringLiteral("-ts"), copy});
        QVERIFY(lupdate.waitForFinished(120'000));
        QCOMPARE(lupdate.exitCode(), 0);

        QMap<std::tuple<QString, QString, QString>, Message> kept;
        for (const Message& message : messagesOf(pathOf(language)))
            kept.insert(message.key(), message);
        QStringList problems;
        const QList<Message> wanted = messagesOf(copy);
        for (const Message& message : wanted)
            if (kept.remove(message.key()) == 0)
                problems.append(QStringLiteral("missing: ") + message.shown());
        for (const Message& message : kept)
            problems.append(QStringLiteral("no longer there: ") + message.shown());
        QVERIFY(wanted.size() > (language == QLatin1String("en") ? 2 : 400));
        QVERIFY2(problems.isEmpty(),
                 qPrintable(problems.join(QStringLiteral("\n")) +
                            QStringLiteral("\nninja update_translations puts new texts into the files")));
    }

    void everyTextIsTranslated_data() { eachLanguage(); }
    void everyTextIsTranslated()
    {
        QFETCH(QString, language);
        for (const Message& message : messagesOf(pathOf(language))) {
            QVERIFY2(message.state.isEmpty(), qPrintable(message.shown()));
            QVERIFY2(!message.forms.isEmpty(), qPrintable(message.shown()));
            for (const QString& form : message.forms)
                QVERIFY2(!form.isEmpty(), qPrintable(message.shown()));
        }
    }

    void placeholdersAndMarksAreThoseOfTheSource_data() { eachLanguage(); }
    void placeholdersAndMarksAreThoseOfTheSource()
    {
        QFETCH(QString, language);
        for (const Message& message : messagesOf(pathOf(language)))
            for (const QString& form : message.forms)
                for (const char* pattern : {R"(%L?[0-9n])", R"(&(?=\w))", R"(\n)", R"(\t)", R"re(\(\*[^)]*\))re",
                                            R"(^\s|\s$)", R"( \.\.\.$)", "…$", "[.;:]$", "^[,;]"})
                    QVERIFY2(partsOf(form, pattern) == partsOf(message.source, pattern),
                             qPrintable(message.shown() + QStringLiteral(" -> ") + form));
    }

    /// These lists stand apart from what they name, which no compiler can compare.
    void everyReasonOfTheRendererCanBeTranslated()
    {
        QStringList known;
        for (const Message& message : messagesOf(pathOf(QStringLiteral("es"))))
            if (message.context == QLatin1String("Rendering"))
                known.append(message.source);
        static const QRegularExpression reason(
            QStringLiteral("unexpected\\((?:std::string\\()?\"((?!The shader)[^\"]*)\""));
        int found = 0;
        const QDir folder(test::sourcePath(u"view/rendering/gl"));
        for (const QString& name : folder.entryList({QStringLiteral("*.cpp")})) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            for (auto match = reason.globalMatch(text); match.hasNext(); ++found) {
                QString sentence = match.next().captured(1);
                if (!sentence.endsWith(QLatin1Char('.')))
                    sentence += QStringLiteral("%1.");
                QVERIFY2(known.contains(sentence), qPrintable(sentence));
            }
        }
        QVERIFY(found >= 4);
    }

    void theLettersOfTheMapsDifferInEveryLanguage_data() { eachLanguage(); }
    void theLettersOfTheMapsDifferInEveryLanguage()
    {
        QFETCH(QString, language);
        QStringList letters;
        for (const Message& message : messagesOf(pathOf(language)))
            if (message.context == QLatin1String("MapLetter")) {
                QCOMPARE(message.forms.front().size(), 1);
                letters += message.forms;
            }
        QCOMPARE(letters.removeDuplicates(), 0);
    }
};

HAIRPAINT_TEST(TestTranslations, Core)
#include "test_translations.moc"
