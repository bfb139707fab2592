#include "viewer/gl_textures.h"

#include <epoxy/gl.h>

namespace cairn::viewer {

namespace {

GLint code_of(TextureStyle::Wrap wrap) {
    switch (wrap) {
    case TextureStyle::Wrap::mirror:
        return GL_MIRRORED_REPEAT;
    case TextureStyle::Wrap::clamp:
        return GL_CLAMP_TO_EDGE;
    case TextureStyle::Wrap::repeat:
        break;
    }
    return GL_REPEAT;
}

// Colors are mixed as light, which is what OpenGL does with textures of sRGB.
GlObject load(const TexturePicture& picture) {
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.texels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, picture.style.is_smooth ? GL_LINEAR : GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, code_of(picture.style.wrap_u));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, code_of(picture.style.wrap_v));
    return texture;
}

} // namespace

void GlTextures::use(const std::shared_ptr<const TexturePicture>& picture) {
    auto place = loaded_.find(picture.get());
    if (place == loaded_.end()) place = loaded_.emplace(picture.get(), Loaded{picture, load(*picture)}).first;
    place->second.unused = 0;
    glBindTexture(GL_TEXTURE_2D, place->second.texture.name());
}

void GlTextures::give_up_unused(int most) {
    for (auto& [source, known] : loaded_) ++known.unused;
    std::erase_if(loaded_, [&](const auto& item) { return item.second.unused > most; });
}

} // namespace cairn::viewer
