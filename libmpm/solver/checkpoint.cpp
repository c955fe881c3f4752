#include "libmpm/solver/checkpoint.hpp"

#include <openssl/evp.h>
#include <new>
#include <stdexcept>

#include "libmpm/solver/archive.hpp"

namespace mpm {
namespace {

void require(int ok) {
  if (ok != 1) throw std::runtime_error("OpenSSL offers no SHA-256 here");
}

}  // namespace

struct Sha256::Context {
  EVP_MD_CTX* openssl = EVP_MD_CTX_new();
};

void Sha256::Free::operator()(Context* context) const {
  EVP_MD_CTX_free(context->openssl);
  delete context;  // NOLINT(cppcoreguidelines-owning-memory)
}

Sha256::Sha256() : context_(new Context) {
  if (context_->openssl == nullptr) throw std::bad_alloc();
  require(EVP_DigestInit_ex(context_->openssl, EVP_sha256(), nullptr));
}

Sha256& Sha256::add(std::string_view bytes) {
  require(EVP_DigestUpdate(context_->openssl, bytes.data(), bytes.size()));
  return *this;
}

std::string Sha256::digest() {
  std::string digest(sha256_bytes, '\0');
  require(EVP_DigestFinal_ex(context_->openssl, reinterpret_cast<unsigned char*>(digest.data()), nullptr));
  return digest;
}

namespace {

void add_stretch(ArchiveWriter& archive, const Stretch& at) {
  archive.whole(static_cast<int>(at.side), 0, 0);
  archive.raw(&at.from, 1);
  archive.raw(&at.to, 1);
}

/// Nothing for a specimen between platens without gauges.
void add_fixture(ArchiveWriter& archive, const Fixture& fixture) {
  for (const Bearing& support : fixture.supports) {
    add_stretch(archive, support.at);
    archive.flag(support.fix_x);
    archive.flag(support.fix_y);
  }
  for (const Load& load : fixture.loads) {
    add_stretch(archive, load.at);
    archive.whole(static_cast<int>(load.way), 0, 0);
    archive.finite(load.share);
    archive.flag(load.leads);
    archive.flag(load.grips);
  }
  for (const Gauge& gauge : fixture.gauges) {
    for (const double place : {gauge.x1, gauge.y1, gauge.x2, gauge.y2}) archive.finite(place);
    archive.whole(static_cast<int>(gauge.direction), 0, 0);
    archive.flag(gauge.controls);
  }
}

}  // namespace

std::string specimen_digest(const Scene& scene) {
  ArchiveWriter archive;
  archive.finite(scene.pixel_size);
  archive.whole(scene.labels.rows(), 0, 0);
  archive.block(scene.labels);
  for (const ExtraPoint& point : scene.extra_points) {
    archive.finite(point.x);
    archive.finite(point.y);
    archive.whole(point.phase, 0, 0);
  }
  add_fixture(archive, scene.fixture);
  return Sha256().add(archive.take()).digest();
}

}  // namespace mpm
