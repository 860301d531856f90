namespace kriva { int g(); int g() { return 1; } }
