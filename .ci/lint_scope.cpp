// A module for clang-tidy that lets its checks look at the project's sources only. By itself
// clang-tidy takes every check through all that a unit includes and hides afterwards what it finds
// in the system's headers: with Eigen that was half of the time.
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>
#include <clang/ASTMatchers/ASTMatchFinder.h>
#include <clang/Basic/SourceManager.h>

namespace {

using clang::ast_matchers::MatchFinder;

// The unit as a whole is matched before what it contains, and clang takes that from the scope.
class OwnSources : public clang::tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;

  void registerMatchers(MatchFinder* finder) override {
    finder->addMatcher(clang::ast_matchers::translationUnitDecl(), this);
  }

  void check(const MatchFinder::MatchResult& result) override {
    std::vector<clang::Decl*> own;
    for (clang::Decl* decl : result.Context->getTranslationUnitDecl()->decls()) {
      const clang::SourceLocation place = decl->getLocation();
      if (place.isValid() && !result.SourceManager->isInSystemHeader(place)) own.push_back(decl);
    }
    result.Context->setTraversalScope(own);
  }
};

class ScopeModule : public clang::tidy::ClangTidyModule {
 public:
  void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override {
    factories.registerCheck<OwnSources>("prehend-own-sources");
  }
};

const clang::tidy::ClangTidyModuleRegistry::Add<ScopeModule> kModule("prehend",
                                                                     "what is looked at");

}  // namespace
