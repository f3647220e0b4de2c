// Objects that threads borrow and give back.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace prehend {

// For what is worth keeping between the tasks of a parallel loop, such as buffers: there are never
// more of them than were on loan at one time. Thread-safe.
template <typename T>
class Pool {
 public:
  // An object that no other loan has, until the loan ends. The pool must outlive its loans.
  class Loan {
   public:
    explicit Loan(Pool& pool) : pool_(pool), lent_(pool.take()) {}
    ~Loan() { pool_.put_back(lent_); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    T* operator->() const { return &lent_; }

   private:
    Pool& pool_;
    T& lent_;
  };

 private:
  T& take() {
    const std::lock_guard lock(lock_);
    if (free_.empty()) {
      all_.push_back(std::make_unique<T>());
      free_.reserve(all_.size());  // so that put_back cannot fail
      return *all_.back();
    }
    T& taken = *free_.back();
    free_.pop_back();
    return taken;
  }

  void put_back(T& lent) {
    const std::lock_guard lock(lock_);
    free_.push_back(&lent);
  }

  std::mutex lock_;
  std::vector<std::unique_ptr<T>> all_;
  std::vector<T*> free_;
};

}  // namespace prehend
