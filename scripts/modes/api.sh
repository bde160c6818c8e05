# --api         reference of all installed headers by Doxygen, build/api/html/index.html; warnings are
#               errors

run_api() {
  install_packages --api
  mkdir -p build
  doxygen docs/api/Doxyfile
  echo "build/api/html/index.html: $(find build/api/html -name '*.html' | wc -l) pages"
}
