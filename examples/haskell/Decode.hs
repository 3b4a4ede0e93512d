import PraTactile
import PraTactile.Files

main :: IO ()
main = do
  frames <- readFolder "data/worked-example/frames"
  either print (either print (mapM_ putStrLn . summary) . decode) frames
  where
    decode folder = canonicalRecogniser >>= (`decodeFolder` folder)
