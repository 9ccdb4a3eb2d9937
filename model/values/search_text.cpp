// Words in texts: see the header.
#include "model/values/search_text.h"

#include <algorithm>

namespace hairpaint::model {

QString searchForm(const QString& text)
{
    QString form = text.normalized(QString::NormalizationForm_KD).toCaseFolded();
    form.removeIf([](QChar letter) {
        return letter.category() == QChar::Mark_NonSpacing || letter.category() == QChar::Mark_Enclosing;
    });
    return form;
}

bool isFound(const QString& words, const QStringList& texts)
{
    QStringList forms;
    for (const QString& text : texts)
        forms.append(searchForm(text));
    const QStringList wanted = searchForm(words.simplified()).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::ranges::all_of(wanted, [&forms](const QString& word) {
        return std::ranges::any_of(forms, [&word](const QString& form) { return form.contains(word); });
    });
}

} // namespace hairpaint::model
