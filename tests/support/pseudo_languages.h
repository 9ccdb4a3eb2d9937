// Languages that nobody speaks: one with long words, one without a plain letter.
#pragma once

#include <QRegularExpression>
#include <QTranslator>

namespace hairpaint::test {

/// German runs about a third longer than English.
class LongWords : public QTranslator
{
public:
    using QTranslator::QTranslator;
    [[nodiscard]] QString translate(const char* /*context*/, const char* source, const char* /*disambiguation*/,
                                    int /*n*/) const override
    {
        const QString text = QString::fromUtf8(source);
        if (text.size() < 4 || text.startsWith(QLatin1Char('%')))
            return text;
        // One longer word for a short text, more words for a sentence.
        return text.size() < 24 ? text + QString(text.size() / 3, QLatin1Char('n'))
                                : text + QStringLiteral(" nnnnnnn").repeated(text.size() / 24);
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

/// Every letter bears a mark ("Brush" is "ßŕúśĥ"), so each plain letter that is still seen came past the translation,
/// however texts are composed, wrapped or cut. Placeholders and lists of file endings stay.
class MarkedLetters : public QTranslator
{
public:
    [[nodiscard]] QString translate(const char* /*context*/, const char* source, const char* /*disambiguation*/,
                                    int /*n*/) const override
    {
        static const QRegularExpression kept(QStringLiteral("%L?[0-9n]|\\(\\*[^)]*\\)"));
        const QString text = QString::fromUtf8(source);
        QString marked;
        qsizetype index = 0;
        const auto mark = [&](qsizetype end) {
            for (; index < end; ++index)
                marked += markedLetter(text[index]);
        };
        for (auto match = kept.globalMatch(text); match.hasNext();) {
            const QRegularExpressionMatch found = match.next();
            mark(found.capturedStart());
            marked += found.captured();
            index = found.capturedEnd();
        }
        mark(text.size());
        return marked;
    }
    [[nodiscard]] bool isEmpty() const override { return false; }

    [[nodiscard]] static QChar markedLetter(QChar letter)
    {
        static const QString lower = QStringLiteral("áḃćďéḟǵĥíĵķĺḿńóṕɋŕśťúṽẃẋýź");
        static const QString upper = QStringLiteral("ÁḂĆĎÉḞǴĤÍĴĶĹḾŃÓṔɊŔŚŤÚṼẂẊÝŹ");
        if (letter >= QLatin1Char('a') && letter <= QLatin1Char('z'))
            return lower[letter.unicode() - 'a'];
        if (letter >= QLatin1Char('A') && letter <= QLatin1Char('Z'))
            return upper[letter.unicode() - 'A'];
        return letter;
    }
};

} // namespace hairpaint::test
