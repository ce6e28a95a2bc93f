#include "acquire/formats/hdf5/hdf5_self_contained.hpp"

#include <hdf5.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "acquire/formats/hdf5/hdf5_input.hpp"
#include "core/error.hpp"

namespace percuss::acquire::hdf5 {
namespace {

constexpr std::size_t kMaxObjects = 100'000, kMaxDepth = 32, kNameShown = 40;
const char* const kRemedy = "save the variables themselves in this file";

// An object by its position in the file. Names could lead elsewhere.
struct Place {
  haddr_t address = 0;
  std::string name;
  std::size_t depth = 0;
};

struct Member {
  std::string name;
  H5L_type_t kind = H5L_TYPE_ERROR;
  haddr_t address = 0;  // of a hard link
};

herr_t append_member(hid_t /*group*/, const char* name, const H5L_info_t* info, void* data) {
  auto& members = *static_cast<std::vector<Member>*>(data);
  if (members.size() > kMaxObjects) return 1;
  members.push_back({.name = name, .kind = info->type, .address = info->type == H5L_TYPE_HARD ? info->u.address : 0});
  return 0;
}

const char* problem_of(H5L_type_t kind) {
  if (kind == H5L_TYPE_EXTERNAL) return "link to another file";
  return kind == H5L_TYPE_SOFT ? "soft link" : "user-defined link";
}

class ObjectWalk {
 public:
  explicit ObjectWalk(const std::string& path) : file_(path) {
    H5O_info_t root{};
    if (H5Oget_info2(file_.id(), &root, H5O_INFO_BASIC) < 0) refuse("damaged", "", "copy or record it again");
    add(root.addr, "", 0);
  }
  void run() {
    while (!open_.empty()) {
      const Place place = std::move(open_.back());
      open_.pop_back();
      const Handle object(H5Oopen_by_addr(file_.id(), place.address));
      if (!object) continue;  // another library cannot open it either
      if (H5Iget_type(object.get()) == H5I_GROUP) check_group(object.get(), place);
      if (H5Iget_type(object.get()) == H5I_DATASET) check_set(object.get(), place);
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& problem, const std::string& name, const char* remedy = kRemedy) const {
    throw InputError(problem, file_.path() + (name.empty() ? "" : ": " + one_line(name, 4 * kNameShown)), remedy);
  }

  void add(haddr_t address, const std::string& name, std::size_t levels) {
    if (!known_.insert(address).second) return;
    if (known_.size() > kMaxObjects) refuse("more than 100000 objects", "", "save fewer variables in a file");
    if (levels > kMaxDepth) refuse("groups within groups more than 32 deep", name, "save plain arrays");
    open_.push_back({.address = address, .name = name, .depth = levels});
  }

  void check_group(hid_t group, const Place& place) {
    std::vector<Member> members;
    hsize_t next = 0;
    // In the order in which matio looks at them.
    if (H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, &next, append_member, &members) < 0)
      refuse("damaged group", place.name, "copy or record it again");
    if (members.size() > kMaxObjects)
      refuse("more than 100000 links in a group", place.name, "save fewer variables in a file");
    for (const Member& member : members) {
      const std::string name = place.name + "/" + one_line(member.name, kNameShown);
      if (member.kind != H5L_TYPE_HARD) refuse(problem_of(member.kind), name);
      add(member.address, name, place.depth + 1);
    }
  }

  void check_set(hid_t set, const Place& place) {
    const Handle creation(H5Dget_create_plist(set)), type(H5Dget_type(set));
    if (!creation || !type) refuse("damaged data set", place.name, "copy or record it again");
    if (H5Pget_layout(creation.get()) == H5D_VIRTUAL || H5Pget_external_count(creation.get()) != 0)
      refuse("its samples are in other files", place.name, "store them in this file");
    if (H5Tdetect_class(type.get(), H5T_REFERENCE) <= 0) return;
    if (H5Tequal(type.get(), H5T_STD_REF_OBJ) <= 0) refuse("references to regions of data sets", place.name);
    add_referenced(set, place);
  }

  // A reference is the position of an object in this file, which no group needs to list.
  void add_referenced(hid_t set, const Place& place) {
    const Handle space(H5Dget_space(set));
    const hssize_t count = H5Sget_simple_extent_npoints(space.get());
    if (count < 0) refuse("damaged data set", place.name, "copy or record it again");
    if (static_cast<std::size_t>(count) > kMaxObjects)
      refuse("more than 100000 references", place.name, "save fewer variables in a file");
    std::vector<hobj_ref_t> references(static_cast<std::size_t>(count));
    if (count > 0 && H5Dread(set, H5T_STD_REF_OBJ, H5S_ALL, H5S_ALL, H5P_DEFAULT, references.data()) < 0)
      refuse("damaged references", place.name, "copy or record it again");
    for (const hobj_ref_t address : references) {
      if (address != 0) add(address, place.name, place.depth + 1);
    }
  }

  InputHdf5 file_;
  std::set<haddr_t> known_;
  std::vector<Place> open_;
};

}  // namespace

void require_self_contained(const std::string& path) { ObjectWalk(path).run(); }

}  // namespace percuss::acquire::hdf5
