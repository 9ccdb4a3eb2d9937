// The textures of cards.
#pragma once

#include <QByteArray>

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::model {

/// What is known of a texel that hair covers; vectors as colours, 0.5 being 0.
struct CardTexel
{
    glm::u8vec3 colour{0};             ///< sRGB as encoded.
    glm::u8vec3 normal{128, 128, 255}; ///< In the card's tangent space, green up.
    glm::u8vec3 flow{128, 0, 128};     ///< Direction toward the tip there, red to the right, green up.
    std::uint8_t rootToTip = 0;        ///< 0 at the root.
    std::uint8_t strandId = 0;         ///< By chance.
    std::uint8_t occlusion = 255;      ///< 255 where nothing occludes the light.
    std::uint8_t depth = 128;          ///< Higher is nearer to the onlooker; 128 on the card.
};

/// One atlas: alpha is how much of each texel hair covers. Distinct texels may be written by several threads.
class CardImages
{
public:
    explicit CardImages(int sizePx);

    [[nodiscard]] int size() const { return m_size; }
    [[nodiscard]] std::size_t indexOf(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] std::vector<CardTexel>& texels() { return m_texels; }
    [[nodiscard]] const std::vector<CardTexel>& texels() const { return m_texels; }
    [[nodiscard]] std::vector<std::uint8_t>& alpha() { return m_alpha; }
    [[nodiscard]] const std::vector<std::uint8_t>& alpha() const { return m_alpha; }

    /// Gives every texel without hair what the nearest one with hair has, so that no border shines through when the
    /// texture is filtered.
    void dilate();

private:
    int m_size;
    std::vector<CardTexel> m_texels;
    std::vector<std::uint8_t> m_alpha;
};

/// A row for each image that is written.
struct CardImageKind
{
    const char* name; ///< "rootToTip": what a file's name ends with.
    bool embedded;    ///< In the glTF itself; the others lie beside it.
};
[[nodiscard]] std::span<const CardImageKind> cardImageKinds();
/// As PNG; the first kind has alpha.
[[nodiscard]] QByteArray cardImagePng(CardImages& images, const CardImageKind& kind);

} // namespace hairpaint::model
