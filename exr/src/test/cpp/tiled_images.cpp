// Tiled and multi-part OpenEXR files by the official C++ library, whose Python wheel writes and reads neither reduced
// levels nor tiles in any order.
//
//   g++ -O1 -o tiled_images tiled_images.cpp $(pkg-config --cflags --libs OpenEXR)    (Debian: libopenexr-dev, pkg-config)
//   tiled_images make DIRECTORY     writes the fixtures tiled_*.exr and parts_*.exr of src/test/resources
//   tiled_images check DIRECTORY    reads all *.exr, every level of every part, and compares each sample bit by bit
//
// Sample values follow the formulas of make_fixtures.py; k counts the channels of a part in sorted order, plus 10 for
// each horizontal level number, 100 for each vertical one and 1000 for each part before. Which formula holds is known by
// the word "noise" in the name of the file.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledInputPart.h>
#include <ImfTiledOutputFile.h>
#include <ImfTiledOutputPart.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

using namespace Imf;
using namespace Imath;

static const int X = -3, Y = 5;

static uint32_t sampleBits(bool noise, PixelType type, uint32_t x, uint32_t y, uint32_t k) {
    if (!noise) {
        uint32_t step = (x * 3 + y * 5 + k * 7) % 257;
        float value = (float(step) - 128) / 16;
        if (type == UINT) return step;
        if (type == HALF) return half(value).bits();
        uint32_t bits;
        memcpy(&bits, &value, 4);
        return bits;
    }
    uint32_t bits = x * 0x9E3779B1u + y * 0x85EBCA77u + k * 0xC2B2AE3Du + 0x27D4EB2Fu;
    bits = (bits ^ (bits >> 15)) * 0x2C1B3C6Du;
    bits = (bits ^ (bits >> 12)) * 0x297A2D39u;
    bits ^= bits >> 15;
    return type == HALF ? bits >> 16 : bits;
}

static int size(PixelType type) { return type == HALF ? 2 : 4; }

// The channels of a part at one level.
struct Planes {
    int width, height;
    std::map<std::string, std::vector<char>> bytes;
    FrameBuffer buffer;

    Planes(const Header &header, int width, int height) : width(width), height(height) {
        const Box2i &window = header.dataWindow();
        for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
            int stride = size(c.channel().type);
            std::vector<char> &plane = bytes[c.name()];
            plane.resize(size_t(width) * height * stride);
            char *base = plane.data() - (window.min.x + ptrdiff_t(window.min.y) * width) * stride;
            buffer.insert(c.name(), Slice(c.channel().type, base, stride, size_t(stride) * width));
        }
    }

    template <class F> void each(const Header &header, bool noise, int lx, int ly, int part, F f) {
        int k = 10 * lx + 100 * ly + 1000 * part;
        for (auto c = header.channels().begin(); c != header.channels().end(); ++c, ++k) {
            PixelType type = c.channel().type;
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++)
                    f(bytes[c.name()].data() + (size_t(y) * width + x) * size(type),
                      sampleBits(noise, type, x, y, k), size(type), c.name(), x, y);
        }
    }

    void fill(const Header &header, bool noise, int lx, int ly, int part) {
        each(header, noise, lx, ly, part,
             [](char *at, uint32_t bits, int n, const char *, int, int) { memcpy(at, &bits, n); });
    }

    void compare(const Header &header, bool noise, int lx, int ly, int part, const std::string &file) {
        each(header, noise, lx, ly, part, [&](char *at, uint32_t bits, int n, const char *name, int x, int y) {
            if (memcmp(at, &bits, n) != 0)
                throw std::runtime_error(file + " part " + std::to_string(part) + " level " + std::to_string(lx) + ", "
                    + std::to_string(ly) + " channel " + name + " at " + std::to_string(x) + ", " + std::to_string(y));
        });
    }
};

static Header makeHeader(int width, int height, Compression compression) {
    Header header(Box2i(V2i(0, 0), V2i(39, 29)), Box2i(V2i(X, Y), V2i(X + width - 1, Y + height - 1)));
    header.compression() = compression;
    header.channels().insert("B", Channel(FLOAT));
    header.channels().insert("G", Channel(HALF));
    header.channels().insert("id", Channel(UINT));
    return header;
}

template <class Out> static void writeLevels(Out &out, const Header &header, bool noise, int part) {
    bool mip = out.levelMode() != RIPMAP_LEVELS;
    for (int ly = 0; ly < out.numYLevels(); ly++)
        for (int lx = mip ? ly : 0; lx < (mip ? ly + 1 : out.numXLevels()); lx++) {
            Planes planes(header, out.levelWidth(lx), out.levelHeight(ly));
            planes.fill(header, noise, lx, ly, part);
            out.setFrameBuffer(planes.buffer);
            if (header.lineOrder() == RANDOM_Y) {
                for (int y = 0; y < out.numYTiles(ly); y++)
                    for (int x = out.numXTiles(lx) - 1; x >= 0; x--) out.writeTile(x, (y + 1) % out.numYTiles(ly), lx, ly);
            } else {
                out.writeTiles(0, out.numXTiles(lx) - 1, 0, out.numYTiles(ly) - 1, lx, ly);
            }
        }
}

static void makeTiled(const std::string &file, Compression compression, LevelMode mode, LevelRoundingMode rounding,
                      LineOrder order, bool noise) {
    Header header = makeHeader(13, 11, compression);
    header.lineOrder() = order;
    header.setTileDescription(TileDescription(8, 5, mode, rounding));
    TiledOutputFile out(file.c_str(), header, 0);
    writeLevels(out, header, noise, 0);
}

static void makeParts(const std::string &file, Compression compression) {
    std::vector<Header> headers;
    for (int part = 0; part < 3; part++) {
        Header header = makeHeader(9 + part, 21 - part, compression);
        header.setName(part == 0 ? "left" : part == 1 ? "right" : "depth");
        header.setType(part == 1 ? TILEDIMAGE : SCANLINEIMAGE);
        if (part == 1) header.setTileDescription(TileDescription(4, 6, MIPMAP_LEVELS, ROUND_UP));
        headers.push_back(header);
    }
    MultiPartOutputFile out(file.c_str(), headers.data(), int(headers.size()), false, 0);
    // Chunks of the first and the last part alternate.
    std::vector<OutputPart> lines{OutputPart(out, 0), OutputPart(out, 2)};
    std::vector<Planes> planes;
    planes.reserve(2);
    for (int i = 0; i < 2; i++) {
        planes.emplace_back(headers[2 * i], 9 + 2 * i, 21 - 2 * i);
        planes[i].fill(headers[2 * i], false, 0, 0, 2 * i);
        lines[i].setFrameBuffer(planes[i].buffer);
    }
    for (int y = 0; y < 21; y++)
        for (int i = 0; i < 2; i++)
            if (y < planes[i].height) lines[i].writePixels(1);
    TiledOutputPart tiles(out, 1);
    writeLevels(tiles, headers[1], false, 1);
}

static void make(const std::string &folder) {
    std::vector<std::pair<const char *, Compression>> compressions = {
        {"none", NO_COMPRESSION}, {"rle", RLE_COMPRESSION},   {"zips", ZIPS_COMPRESSION},
        {"zip", ZIP_COMPRESSION}, {"piz", PIZ_COMPRESSION},   {"pxr24", PXR24_COMPRESSION}};
    const char *modes[] = {"one", "mip", "rip"};
    const char *roundings[] = {"down", "up"};
    int count = 0;
    for (auto &[name, compression] : compressions) {
        for (int mode = 0; mode < 3; mode++)
            for (int rounding = 0; rounding < 2; rounding++)
                makeTiled(folder + "/tiled_" + name + "_" + modes[mode] + "_" + roundings[rounding] + ".exr", compression,
                          LevelMode(mode), LevelRoundingMode(rounding), LineOrder(count++ % 3), false);
        makeParts(folder + "/parts_" + name + ".exr", compression);
    }
    makeTiled(folder + "/tiled_zip_mip_noise.exr", ZIP_COMPRESSION, MIPMAP_LEVELS, ROUND_DOWN, INCREASING_Y, true);
    makeTiled(folder + "/tiled_piz_rip_noise.exr", PIZ_COMPRESSION, RIPMAP_LEVELS, ROUND_UP, RANDOM_Y, true);
}

static void check(const std::filesystem::path &path) {
    std::string file = path.string();
    bool noise = path.filename().string().find("noise") != std::string::npos;
    MultiPartInputFile in(file.c_str());
    for (int part = 0; part < in.parts(); part++) {
        const Header &header = in.header(part);
        if (header.type() == TILEDIMAGE) {
            TiledInputPart tiles(in, part);
            bool mip = tiles.levelMode() != RIPMAP_LEVELS;
            for (int ly = 0; ly < tiles.numYLevels(); ly++)
                for (int lx = mip ? ly : 0; lx < (mip ? ly + 1 : tiles.numXLevels()); lx++) {
                    Planes planes(header, tiles.levelWidth(lx), tiles.levelHeight(ly));
                    tiles.setFrameBuffer(planes.buffer);
                    tiles.readTiles(0, tiles.numXTiles(lx) - 1, 0, tiles.numYTiles(ly) - 1, lx, ly);
                    planes.compare(header, noise, lx, ly, part, file);
                }
        } else {
            const Box2i &window = header.dataWindow();
            Planes planes(header, window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
            InputPart lines(in, part);
            lines.setFrameBuffer(planes.buffer);
            lines.readPixels(window.min.y, window.max.y);
            planes.compare(header, noise, 0, 0, part, file);
        }
    }
}

int main(int argc, char **argv) {
    try {
        if (argc == 3 && !strcmp(argv[1], "make")) {
            make(argv[2]);
            return 0;
        }
        if (argc == 3 && !strcmp(argv[1], "check")) {
            int count = 0;
            for (auto &entry : std::filesystem::directory_iterator(argv[2]))
                if (entry.path().extension() == ".exr") {
                    check(entry.path());
                    count++;
                }
            printf("%d files agree\n", count);
            return 0;
        }
        fprintf(stderr, "usage: tiled_images make|check DIRECTORY\n");
    } catch (const std::exception &e) {
        fprintf(stderr, "%s\n", e.what());
    }
    return 1;
}
