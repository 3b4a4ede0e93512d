{-# LANGUAGE CPP #-}

-- | Which kind of database a name means.
module PraTactile.Store.Known
  ( backendOf,
    shownName,
  )
where

import PraTactile.Store.Address
import PraTactile.Store.Backend (Backend)
import PraTactile.Store.Error (StoreError (..))
#ifdef POSTGRESQL
import PraTactile.Store.Postgresql (postgresql)
#endif
import PraTactile.Store.Sqlite (sqlite)

-- | The database of this name: on a server where it is an address, else in a file.
backendOf :: String -> Either StoreError Backend
backendOf name
  | isAddress name = maybe (Left UnreadableAddress) onServer (readAddress name)
  | otherwise = Right (sqlite name)

onServer :: Address -> Either StoreError Backend
#ifdef POSTGRESQL
onServer = Right . postgresql
#else
onServer = Left . WithoutServers . shownAddress
#endif

-- | A database's name as it is shown, without a password; of an address that cannot be read only
-- what kind of name it is.
shownName :: String -> String
shownName name
  | isAddress name = maybe "postgresql://..." shownAddress (readAddress name)
  | otherwise = name
