// What a style says of itself.
#pragma once

#include <QDialog>
#include <QImage>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

class QFormLayout;
class QLabel;
class QProgressBar;

namespace hairpaint::view {

/// Four pictures and facts, which come one after the other while it is open. GUI thread.
class StyleCard : public QDialog
{
    Q_OBJECT
public:
    static constexpr std::size_t kPictures = 4; ///< Front, left, right, back.
    static constexpr int kPictureSide = 200;

    StyleCard(const QString& name, bool isForeignHead, QWidget* parent);

    void setPicture(std::size_t index, const QImage& picture);
    /// Pairs of a fact's name and its text.
    void addFacts(const std::vector<std::pair<QString, QString>>& facts);
    void tellProblem(const QString& problem); ///< Shown instead of the pictures and facts that have not come.

Q_SIGNALS:
    void putOnWanted();
    void landmarksWanted(); ///< The landmarks of the open head, which is not one of the program's, are to be set.

private:
    std::array<QLabel*, kPictures> m_pictures{};
    QFormLayout* m_facts = nullptr;
    QProgressBar* m_progress = nullptr;
    QLabel* m_problem = nullptr;
};

} // namespace hairpaint::view
